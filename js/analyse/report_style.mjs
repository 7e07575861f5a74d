/** Style of the report: light and dark by the reader's scheme, narrow and wide, and on paper. */
export const STYLE = `:root{--back:#fff;--text:#161616;--dim:#5c5c5c;--line:#d4d4d4;--accent:#2867b8;--heat-colour:#e8a35c;--check:#e6e6e6}
@media (prefers-color-scheme:dark){:root{--back:#16181b;--text:#e8e8e8;--dim:#a2a2a2;--line:#3a3d42;--accent:#7db2f5;--heat-colour:#8a5423;--check:#24272b}}
*{box-sizing:border-box}body{font:15px/1.45 system-ui,sans-serif;margin:1.5rem auto;padding:0 1rem;max-width:88rem;background:var(--back);color:var(--text)}
h1{font-size:1.5rem}h2{font-size:1.2rem;margin:2rem 0 .5rem}h3{font-size:1rem;margin:1.4rem 0 .3rem}p{max-width:70rem;margin:.4rem 0}
.wide{overflow-x:auto}table{border-collapse:collapse;margin:.6rem 0;font-variant-numeric:tabular-nums;font-size:.88rem}
th,td{padding:.25rem .6rem;text-align:right;border-bottom:1px solid var(--line);vertical-align:top}thead th{font-weight:600;color:var(--dim);vertical-align:bottom}
th[scope=row]{text-align:left;white-space:nowrap}.words{text-align:left;min-width:9rem}th.words{min-width:0;white-space:normal}small{color:var(--dim);font-weight:400;white-space:nowrap}td{white-space:nowrap}td.words{white-space:normal}.none{color:var(--dim)}.sum th,.sum td{border-top:2px solid var(--line)}
.bar{width:7rem;min-width:5rem}.bar span{display:block;height:.8rem;margin-top:.25rem;background:var(--accent);min-width:1px}
.heat td{background:color-mix(in srgb,var(--heat-colour) var(--heat,0%),transparent)}
figure{margin:0}.pictures,.plots{display:flex;flex-wrap:wrap;gap:.8rem;margin:.5rem 0}.pictures figure{flex:0 0 max(10.5rem,calc((100% - 4rem)/6));max-width:47%}
.plots figure{max-width:100%}.plots svg{max-width:100%;height:auto}figcaption{font-size:.8rem;color:var(--dim)}figcaption b{color:var(--text);font-weight:600}
img{width:100%;height:auto;display:block;background:repeating-conic-gradient(var(--check) 0 25%,transparent 0 50%) 0 0/16px 16px}
@media print{:root{--back:#fff;--text:#000;--dim:#444;--line:#bbb;--check:#fff;--accent:#2867b8;--heat-colour:#e8a35c}body{margin:0;max-width:none;font-size:9.5pt}section,tr,figure{break-inside:avoid}
.wide{overflow:visible}table{font-size:6.6pt}th,td{padding:.1rem .25rem}.words{min-width:0}th[scope=row]{white-space:normal}.bar{min-width:2rem;width:3rem}.bar span,.heat td{print-color-adjust:exact;-webkit-print-color-adjust:exact}.pictures figure{flex-basis:30%}td{white-space:normal}h2{break-after:avoid}}`;
