import { readdirSync } from 'node:fs';
import sharp from 'sharp';
import { compareImages } from '/work/wt/gate/js/compare/compare.mjs';
import { judge } from '/work/wt/gate/js/compare/gates.mjs';
const dir='/work/wt/gate/out/parity/pictures/';
const read=async f=>{const {data,info}=await sharp(dir+f).ensureAlpha().raw().toBuffer({resolveWithObject:true});return {width:info.width,height:info.height,data:new Uint8Array(data)}};
const names=readdirSync(dir).filter(f=>f.endsWith('.other.png')).map(f=>f.slice(0,-10));
const rows=[];
for(const n of names){const c=compareImages(await read(n+".other.png"),await read(n+".telar.png"));const o=c.object;rows.push([n,o.flip.mean,o.deltaE.mean,o.deltaE.p95]);}
for(const k of [1,2,3]){rows.sort((a,b)=>b[k]-a[k]);console.log(k,rows.slice(0,12).map(r=>r[0]+" "+r[k].toFixed(4)).join(", "))}
