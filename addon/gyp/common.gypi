# node-gyp's --nodedir points here: it insists on a header folder, and we compile with the npm package node-api-headers.
{
  'variables': {},
}
