// Acts on the page of the gantry as a person does, and says what the page shows after each step.
const [plots, main] = [document.getElementById("plots"), document.querySelector("main")];
const state = () => [main.dataset.from, main.dataset.to, main.dataset.cursor].map((time) => Number(time).toFixed(2)).join(" ");
const key = (key, shiftKey = false) => {
  plots.dispatchEvent(new KeyboardEvent("keydown", { key, shiftKey, bubbles: true, cancelable: true }));
  say(`${shiftKey ? "Shift " : ""}${key}: ${state()}`);
};
key("End"); key("Home"); key("ArrowRight"); key("ArrowRight", true);
document.getElementById("at").value = "6";
document.getElementById("at").dispatchEvent(new Event("change"));
say(`field: ${state()}`);
key("+"); key("ArrowRight", true); key("-"); key("0");
const press = (name) => { document.querySelector(`[data-do=${name}]`).click(); say(`${name}: ${state()}`); };
press("zoom-in"); press("zoom-in"); press("forth"); press("back"); press("zoom-out"); press("whole");
const picture = plots.querySelector("svg");
const area = picture.querySelector(".area").getBoundingClientRect();
const at = (part) => ({ clientX: area.left + part * area.width, clientY: area.top + 20, bubbles: true, button: 0 });
const pointer = (kind, part, more = {}) => picture.dispatchEvent(new PointerEvent(kind, { ...at(part), ...more }));
pointer("pointerdown", 0.25); pointer("pointerup", 0.25);
say(`click: ${state()}`);
pointer("pointerdown", 0.5, { shiftKey: true }); pointer("pointermove", 0.75);
const selection = document.querySelector(".selection").getBoundingClientRect();
say(`selected: ${Math.round((100 * (selection.left - area.left)) / area.width)} ${Math.round((100 * selection.width) / area.width)}`);
pointer("pointerup", 0.75);
say(`select: ${state()}`);
// A page that gets another size is drawn at once, and not with the next frame.
const draw = () => window.dispatchEvent(new Event("resize"));
draw();
pointer("pointerdown", 0.5); pointer("pointermove", 0.25); pointer("pointerup", 0.25);
say(`drag: ${state()}`);
draw();
picture.dispatchEvent(new WheelEvent("wheel", { ...at(0), deltaY: -1, ctrlKey: true, cancelable: true }));
say(`wheel: ${state()}`);
const velocity = document.querySelector("[data-group=velocity] svg");
const labels = () => [...velocity.querySelectorAll("text[text-anchor=end]")].map((label) => label.textContent).join(" ");
document.getElementById("at").value = "9";
document.getElementById("at").dispatchEvent(new Event("change"));
for (let times = 0; times < 5; times += 1) {
  document.querySelector("[data-do=zoom-in]").click();
}
draw();
say(`heights: ${labels()}`);
document.getElementById("fit").click();
draw();
say(`fitted: ${labels()}`);
picture.dispatchEvent(new MouseEvent("dblclick", { bubbles: true }));
say(`double click: ${state()}`);
draw();
[...document.querySelectorAll("#output .moment")].at(-1).click();
say(`output: ${state()}`);
draw();
