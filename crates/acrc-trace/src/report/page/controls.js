// Mouse, fingers, keys and buttons.

const STEPS = 200;
const ZOOM = 1.5;

/** Connects the plots and the toolbar with a view. */
function connect(view, plots, timeScale) {
  connectKeys(view, plots);
  connectPointer(view, plots, timeScale);
  const actions = {
    "zoom-in": () => view.zoom(1 / ZOOM),
    "zoom-out": () => view.zoom(ZOOM),
    back: () => view.pan(-0.25),
    forth: () => view.pan(0.25),
    whole: () => view.whole(),
  };
  byId("toolbar").addEventListener("click", (event) => actions[event.target.dataset.do]?.());
  const at = byId("at");
  at.addEventListener("change", () => {
    if (at.value !== "" && Number.isFinite(at.valueAsNumber)) {
      view.show(at.valueAsNumber);
    }
  });
  byId("fit").addEventListener("change", (event) => {
    view.fit = event.target.checked;
    view.change();
  });
}

function connectKeys(view, plots) {
  const step = () => (view.to - view.from) / STEPS;
  const keys = {
    ArrowLeft: (shift) => (shift ? view.pan(-0.1) : view.show(view.cursor - step())),
    ArrowRight: (shift) => (shift ? view.pan(0.1) : view.show(view.cursor + step())),
    PageUp: () => view.pan(-0.9),
    PageDown: () => view.pan(0.9),
    Home: () => view.show(view.begin),
    End: () => view.show(view.end),
    "+": () => view.zoom(1 / ZOOM),
    "=": () => view.zoom(1 / ZOOM),
    "-": () => view.zoom(ZOOM),
    0: () => view.whole(),
  };
  plots.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !Object.hasOwn(keys, event.key)) {
      return;
    }
    keys[event.key](event.shiftKey);
    event.preventDefault();
  });
}

function connectPointer(view, plots, timeScale) {
  let drag = null;
  const selection = html("div", { class: "selection", hidden: "" });
  plots.append(selection);
  const end = () => {
    drag = null;
    selection.hidden = true;
    plots.classList.remove("dragged");
  };
  const timeAt = (event) => {
    const { left, scale } = timeScale();
    return scale.value(event.clientX - left);
  };
  plots.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !event.target.closest("svg")) {
      return;
    }
    drag = { x: event.clientX, time: timeAt(event), select: event.shiftKey, moved: false, ...timeScale() };
    drag.range = [view.from, view.to];
  });
  window.addEventListener("pointermove", (event) => {
    if (!drag || (!drag.moved && Math.abs(event.clientX - drag.x) < 4)) {
      return;
    }
    drag.moved = true;
    plots.classList.add("dragged");
    if (drag.select) {
      const left = Math.min(drag.x, event.clientX) - plots.getBoundingClientRect().left;
      Object.assign(selection.style, { left: `${left}px`, width: `${Math.abs(event.clientX - drag.x)}px` });
      selection.hidden = false;
    } else {
      const shift = drag.scale.value(drag.x) - drag.scale.value(event.clientX);
      view.setRange(drag.range[0] + shift, drag.range[1] + shift);
    }
  });
  window.addEventListener("pointerup", (event) => {
    if (drag && drag.moved && drag.select) {
      const [from, to] = [drag.time, timeAt(event)].sort((left, right) => left - right);
      view.setRange(from, to);
    } else if (drag && !drag.moved) {
      view.setCursor(drag.time);
    }
    end();
  });
  window.addEventListener("pointercancel", end);
  plots.addEventListener("dblclick", () => view.whole());
  plots.addEventListener(
    "wheel",
    (event) => {
      // Without a click into the plots before, the wheel scrolls the page.
      if ((!event.ctrlKey && document.activeElement !== plots) || !event.target.closest("svg")) {
        return;
      }
      event.preventDefault();
      const time = Math.min(Math.max(timeAt(event), view.from), view.to);
      view.zoom(event.deltaY > 0 ? 1.2 : 1 / 1.2, time);
    },
    { passive: false },
  );
}
