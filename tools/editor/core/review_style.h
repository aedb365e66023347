// The review page's style and script: text alone.
#pragma once

namespace lanthorn::editor {

inline constexpr const char* kReviewStyle = R"(
body{background:#262626;color:#e4e4e4;font:15px/1.4 'DejaVu Sans',sans-serif;margin:24px auto;max-width:1000px;padding:0 16px}
h1{font-size:24px}h2{font-size:18px;margin:28px 0 6px}.pose,.note{color:#a0a0a0;font-size:13px;margin:4px 0}
.pair{position:relative;width:100%;line-height:0}.pair img{width:100%;display:block}
.pair .after{position:absolute;inset:0;clip-path:inset(0 0 0 50%)}
.pair input{position:absolute;inset:0;width:100%;height:100%;margin:0;opacity:0;cursor:ew-resize}
.pair::after{content:'';position:absolute;top:0;bottom:0;left:var(--at,50%);width:2px;background:#ffb040;pointer-events:none}
.pair b{position:absolute;top:8px;padding:10px 8px;background:#000a;font-size:12px;pointer-events:none}.pair .l{left:8px}.pair .r{right:8px}
.pair:focus-within{outline:2px solid #ffb040}
section .lux,section .error{display:none}section.lux .final,section.error .final{display:none}
section.lux .lux,section.error .error{display:block}
.tabs button{background:#1d1d1d;color:#e4e4e4;border:1px solid #555;padding:4px 14px;margin:0 6px 8px 0;font:inherit;cursor:pointer}
.tabs button.on{background:#2f5070}
table{border-collapse:collapse;margin:8px 0}th,td{text-align:left;padding:3px 14px 3px 0;font-weight:normal;vertical-align:top}
th{color:#a0a0a0}.kept{color:#6cd07c}.broken{color:#ff6b5e}.broken::before{content:'! '}
pre{background:#1d1d1d;padding:10px;overflow-x:auto;font:13px/1.35 'DejaVu Sans Mono',monospace}.plus{color:#6cd07c}.minus{color:#ff9c3a}
)";

inline constexpr const char* kReviewScript = R"(
for(const s of document.querySelectorAll('section')){
 const b=[...s.querySelectorAll('.tabs button')];
 const show=k=>{s.className=k;b.forEach(x=>x.classList.toggle('on',x.dataset.show===k))};
 b.forEach(x=>x.onclick=()=>show(x.dataset.show));if(b.length)show('final');
 const p=[...s.querySelectorAll('.pair')];
 p.forEach(d=>d.querySelector('input').oninput=e=>p.forEach(q=>{const v=e.target.value/10;q.querySelector('input').value=e.target.value;
  q.querySelector('.after').style.clipPath=`inset(0 0 0 ${v}%)`;q.style.setProperty('--at',v+'%')}));
}
)";

}  // namespace lanthorn::editor
