#include "tools/replay_suite/html_parts.h"

namespace lanthorn::suite {

const char* const kPageStyle = R"(
:root{--ink:#1d2226;--soft:#5d6870;--line:#d9dee2;--paper:#fff;--shade:#f4f6f7;
--ok:#1a7f4b;--okb:#e4f4ea;--bad:#b3261e;--badb:#fbe6e4;--crash:#8a1c7c;--crashb:#f6e3f3;--flaky:#96590a;--flakyb:#fdeed6;
--acc:#2b5f9e;--accb:#e3edf9;--none:#6b757c;--noneb:#eceff1}
@media(prefers-color-scheme:dark){:root{--ink:#e6eaed;--soft:#a3adb4;--line:#3a4248;--paper:#171b1e;--shade:#20262a;
--ok:#6fd39b;--okb:#16382a;--bad:#ff9a90;--badb:#47211f;--crash:#ef9fe3;--crashb:#3f1f3a;--flaky:#f5c071;--flakyb:#40301a;
--acc:#94c1f5;--accb:#1c304a;--none:#a3adb4;--noneb:#2b3237}}
*{box-sizing:border-box}
body{font:15px/1.5 system-ui,"DejaVu Sans",sans-serif;color:var(--ink);background:var(--paper);margin:0 auto;max-width:1180px;padding:20px 20px 80px}
h1{font-size:22px;margin:0}h2{font-size:18px;margin:34px 0 10px}
code,pre{font:13px/1.45 "DejaVu Sans Mono",monospace}
pre{background:var(--shade);padding:8px 10px;margin:6px 0;white-space:pre-wrap;overflow-wrap:anywhere;border-radius:4px}
.strip{border:1px solid var(--line);border-left:10px solid var(--ok);border-radius:4px;padding:14px 18px;margin-bottom:16px}
.strip.red{border-left-color:var(--bad)}.strip.lost{border-left-color:var(--none)}
.verdict{font-size:26px;font-weight:700}.strip .verdict{color:var(--ok)}.strip.red .verdict{color:var(--bad)}.strip.lost .verdict{color:var(--none)}
.receipt{display:flex;flex-wrap:wrap;gap:4px 26px;margin:10px 0 4px;padding:0;list-style:none}
.receipt b{font-size:18px;font-variant-numeric:tabular-nums}.receipt span{color:var(--soft)}
.small{color:var(--soft);font-size:13px}
.counters{display:flex;flex-wrap:wrap;gap:8px;margin:14px 0}
.counters a,.counters button{font:inherit;color:inherit;text-decoration:none;border:1px solid var(--line);background:var(--shade);border-radius:4px;padding:6px 14px;cursor:pointer}
.counters b{font-size:18px;margin-right:6px;font-variant-numeric:tabular-nums}
.counters [aria-pressed=true]{outline:3px solid var(--acc)}
.tools{display:none;gap:12px;margin:10px 0}.js .tools{display:flex}
.tools input{font:inherit;padding:5px 9px;min-width:280px;border:1px solid var(--line);background:var(--paper);color:inherit;border-radius:4px}
table{border-collapse:collapse;width:100%}
th,td{text-align:left;padding:5px 10px;border-bottom:1px solid var(--line);vertical-align:top}
th{background:var(--shade);position:sticky;top:0;font-weight:600}.js th{cursor:pointer}
td:first-child{white-space:nowrap}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.sign{display:inline-block;min-width:26px;text-align:center;border-radius:3px;padding:0 6px;font-weight:700}
.ok{color:var(--ok);background:var(--okb)}.failed{color:var(--bad);background:var(--badb)}
.crashed{color:var(--crash);background:var(--crashb)}.flaky{color:var(--flaky);background:var(--flakyb)}
.accepted{color:var(--acc);background:var(--accb)}.lost,.none{color:var(--none);background:var(--noneb)}
details{border:1px solid var(--line);border-radius:4px;margin:10px 0;padding:0 14px}
summary{cursor:pointer;padding:9px 0;font-weight:600}summary .small{font-weight:400}
details[open]{padding-bottom:12px}
.lanes{width:100%;height:auto;display:block;margin:8px 0}
.lanes text{font:11px "DejaVu Sans",sans-serif;fill:var(--soft)}
.lane{fill:var(--shade)}.in{fill:var(--acc)}.pt{fill:var(--flaky)}.eq{fill:var(--ok)}.ne{fill:var(--bad)}.mk{stroke:var(--ink)}
.dv{stroke:var(--bad);stroke-width:2}.cr{stroke:var(--crash);stroke-width:2}
.figures{display:flex;flex-wrap:wrap;gap:10px}figure{margin:0}figcaption{font-size:12px;color:var(--soft)}
.picture,.over{width:320px;max-width:100%;height:auto;display:block;image-rendering:pixelated}
.wipe{position:relative;width:320px;max-width:100%}.wipe .over{position:absolute;top:0;left:0;clip-path:inset(0 0 0 var(--cut,50%))}
.wipe input{display:none}.js .wipe input{display:block;width:100%;margin:4px 0 0}
.copy{display:none}.js .copy{display:inline-block;font:12px sans-serif;float:right;margin:7px 8px;cursor:pointer}
[hidden]{display:none!important}:focus-visible{outline:3px solid var(--acc);outline-offset:2px}
@media(prefers-color-scheme:dark){.lanes{color-scheme:dark}}
)";

const char* const kPageScript = R"(
document.documentElement.classList.add('js');
const rows=[...document.querySelectorAll('#runs tbody tr')],text=document.getElementById('filter');
const buttons=[...document.querySelectorAll('.counters [data-state]')];
let state='';
const view=new URLSearchParams(location.hash.startsWith('#?')?location.hash.slice(2):'');
function show(){
  const words=text.value.toLowerCase();
  let shown=0;
  rows.forEach(r=>{
    r.hidden=(state&&r.dataset.state!==state)||!r.textContent.toLowerCase().includes(words);
    const d=document.getElementById(r.dataset.of);
    if(d)d.hidden=r.hidden;
    shown+=r.hidden?0:1;
  });
  document.getElementById('shown').textContent=shown+' of '+rows.length+' shown';
  buttons.forEach(b=>b.setAttribute('aria-pressed',b.dataset.state===state));
}
function keep(){
  const v=new URLSearchParams();
  if(state)v.set('state',state);
  if(text.value)v.set('text',text.value);
  history.replaceState(null,'',v.toString()?'#?'+v:'#');
}
buttons.forEach(b=>b.addEventListener('click',e=>{e.preventDefault();state=state===b.dataset.state?'':b.dataset.state;show();keep();}));
text.addEventListener('input',()=>{show();keep();});
document.querySelectorAll('th').forEach(th=>{
  th.tabIndex=0;
  let up=false;
  const sort=()=>{
    up=!up;
    const body=th.closest('table').tBodies[0],column=th.cellIndex;
    const key=r=>{const c=r.cells[column];return c.dataset.n!==undefined?parseFloat(c.dataset.n):c.textContent;};
    [...body.rows].sort((a,b)=>{const x=key(a),y=key(b),d=x<y?-1:x>y?1:0;return up?d:-d;}).forEach(r=>body.append(r));
  };
  th.addEventListener('click',sort);
  th.addEventListener('keydown',e=>{if(e.key==='Enter')sort();});
});
document.querySelectorAll('.copy').forEach(b=>b.addEventListener('click',()=>{
  const line=b.nextElementSibling.textContent;
  (navigator.clipboard?navigator.clipboard.writeText(line):Promise.reject()).then(()=>{b.textContent='copied';},
    ()=>{const s=getSelection();s.selectAllChildren(b.nextElementSibling);document.execCommand('copy');b.textContent='copied';});
}));
document.querySelectorAll('.wipe input').forEach(i=>i.addEventListener('input',()=>i.parentElement.style.setProperty('--cut',i.value+'%')));
function open(){
  const d=location.hash.length>1&&!location.hash.startsWith('#?')&&document.getElementById(location.hash.slice(1));
  if(d&&d.tagName==='DETAILS')d.open=true;
}
addEventListener('hashchange',open);
document.addEventListener('keydown',e=>{
  if(e.target.tagName==='INPUT'||e.ctrlKey||e.altKey||e.metaKey)return;
  const red=[...document.querySelectorAll('details[data-red]')].filter(d=>!d.hidden);
  const at=red.indexOf(document.activeElement.closest('details'));
  if((e.key==='n'||e.key==='p')&&red.length){
    const d=red[(at+(e.key==='n'?1:red.length-1)+(at<0&&e.key==='p'?1:0))%red.length];
    d.open=true;d.querySelector('summary').focus();d.scrollIntoView();
  }else if(e.key==='/'){e.preventDefault();text.focus();}
});
state=view.get('state')||'';text.value=view.get('text')||'';show();open();
)";

}  // namespace lanthorn::suite
