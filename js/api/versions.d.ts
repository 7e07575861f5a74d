export interface Versions {
  telar: string;
  node: string;
  napi: string;
}

export const versions: Readonly<Versions>;
