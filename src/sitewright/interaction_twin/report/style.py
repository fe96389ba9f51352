"""How the report page looks, on the screen and on paper."""

from __future__ import annotations

STYLE = """
body{font:15px/1.5 system-ui,'DejaVu Sans',sans-serif;color:#1c2733;background:#fff;margin:0}
main{max-width:1160px;margin:0 auto;padding:24px 20px 48px}
h1{font-size:26px;margin:0 0 4px}h2{font-size:18px;margin:32px 0 8px}
.lead{color:#44566c;margin:0 0 16px}
.state{display:inline-block;padding:2px 12px;border-radius:12px;color:#fff;background:#5c6b7a}
.state.complete{background:#2f7d4f}.state.held,.state.finished{background:#b8651b}
.figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(170px,1fr));gap:10px;
margin:16px 0}
.figure{border:1px solid #d5dde6;border-radius:8px;padding:8px 12px}
.figure b{display:block;font-size:20px}.figure span{color:#44566c;font-size:13px}
.figure.bad{border-color:#c0392b;background:#fdf3f2}
table{border-collapse:collapse;width:100%;font-size:14px}
th,td{text-align:left;padding:4px 10px 4px 0;border-bottom:1px solid #e3e9f0;vertical-align:top}
td.n,th.n{text-align:right;padding-right:22px}
.wide{overflow-x:auto}.wide td,.wide th{white-space:nowrap}.wide td:last-child{white-space:normal}
.picture{overflow-x:auto}.picture svg{display:block;max-width:100%;height:auto}
.schedule svg{min-width:760px}
.two{display:grid;grid-template-columns:1fr 1fr;gap:20px 40px}.two>*{min-width:0}
.two .wide th{white-space:normal;vertical-align:bottom}.two td.n,.two th.n{padding-right:12px}
footer{margin-top:40px;color:#5c6b7a;font-size:13px;border-top:1px solid #e3e9f0;padding-top:10px}
@media (max-width:800px){.two{grid-template-columns:1fr}}
@media print{body{font-size:12px;print-color-adjust:exact;-webkit-print-color-adjust:exact}
main{max-width:none;padding:0}h1{font-size:22px}h2{font-size:15px;margin:18px 0 6px;
break-after:avoid}
table{font-size:11px}.figure b{font-size:16px}.figures{grid-template-columns:repeat(6,1fr);gap:6px}
.figure,tr,svg,.picture{break-inside:avoid}.wide,.picture{overflow:visible}thead{display:table-header-group}
.schedule svg{min-width:0}footer{margin-top:14px;font-size:10px}
@page{size:A4 landscape;margin:12mm}}
"""
