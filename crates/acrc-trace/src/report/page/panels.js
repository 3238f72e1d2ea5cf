// The plots over time: panels of curves, and a panel of lanes for bits.

const MARGIN = { left: 76, right: 22, top: 6, bottom: 20 };
const CURVE_HEIGHT = 170;
const LANE_HEIGHT = 18;
const MARK_ROW = 14;
const COLORS = 7;
const DASHES = ["", "6 3", "2 2.5", "8 3 2 3"];

/** The panels of a run: the signals of one group and kind each. */
function makePanels(run) {
  const panels = [];
  const owners = [];
  const faults = run.faults.map(([time, text]) => [time, `fault: ${text}`]);
  const marks = [...run.events, ...faults].sort(([left], [right]) => left - right);
  for (const signal of run.signals) {
    const lanes = signal instanceof Bit;
    let panel = panels.find((known) => known.group === signal.group && known.lanes === lanes);
    if (!panel) {
      panel = { group: signal.group, lanes, signals: [] };
      panels.push(panel);
    }
    const owner = signal.name.split(".")[0];
    if (!lanes && !owners.includes(owner)) {
      owners.push(owner);
    }
    const color = lanes ? 0 : owners.indexOf(owner) % COLORS;
    const repeat = panel.signals.filter((known) => known.color === color).length;
    panel.signals.push({ signal, color, dash: lanes ? "" : DASHES[repeat % DASHES.length] });
  }
  return panels.map((panel, index) => {
    const place = { index, events: index === 0 ? marks : [], last: index === panels.length - 1, marks };
    return panel.lanes ? new LanePanel(panel, place) : new CurvePanel(panel, place);
  });
}

/** What panels of both kinds share. */
class Panel {
  constructor({ group, signals }, { index, events, last, marks }, height) {
    Object.assign(this, { group, signals, index, events, last, marks });
    this.height = height;
    this.svg = svg("svg", { role: "img", "aria-label": this.label() });
    this.legend = html("ul", { class: "legend" });
    this.values = signals.map(({ signal, color, dash }) => this.addLegend(signal, color, dash));
    this.element = html("figure", { class: "panel", "data-group": group }, this.svg, this.legend);
  }

  label() {
    return `${this.title()} over time: ${this.signals.map(({ signal }) => signal.name).join(", ")}`;
  }

  title() {
    const units = [...new Set(this.signals.map(({ signal }) => signal.unit).filter((unit) => unit !== ""))];
    return units.length === 0 ? this.group : `${this.group} [${units.join(", ")}]`;
  }

  addLegend(signal, color, dash) {
    const swatch = html("span", { class: "swatch", style: swatchStyle(color, dash) });
    const value = html("span", { class: "value", "data-signal": signal.name });
    const about = signal.source === "" ? signal.name : `${signal.name} (${signal.source})`;
    this.legend.append(html("li", {}, swatch, html("span", { class: "name", title: about }, signal.name), value));
    return value;
  }

  /** Draws everything that depends on the stretch of time. */
  draw(view, width) {
    const marks = this.placeMarks(view, width);
    const top = MARGIN.top + marks.rows * MARK_ROW;
    const area = { left: MARGIN.left, right: width - MARGIN.right, top, bottom: top + this.height };
    const total = area.bottom + MARGIN.bottom + (this.last ? 14 : 0);
    this.svg.setAttribute("viewBox", `0 0 ${width} ${total}`);
    this.svg.setAttribute("height", total);
    this.legend.style.setProperty("--top", `${top}px`);
    this.time = new Scale(view.from, view.to, area.left, area.right);
    const clip = `clip-${this.index}`;
    const size = { x: area.left, y: area.top, width: area.right - area.left, height: this.height };
    this.svg.replaceChildren(
      svg("clipPath", { id: clip }, svg("rect", size)),
      svg("rect", { class: "area", ...size }),
      this.timeAxis(area),
      ...this.content(view, area),
      svg("g", { "clip-path": `url(#${clip})` }, ...this.curves(view, area)),
      ...this.drawMarks(marks, area, top),
      this.cursorLine(view, area),
    );
  }

  timeAxis(area) {
    const group = svg("g");
    for (const { value, label } of this.time.ticks((area.right - area.left) / 90)) {
      const x = this.time.at(value);
      group.append(svg("path", { class: "grid", d: `M${x.toFixed(1)} ${area.top}V${area.bottom}` }));
      group.append(svg("text", { x: x.toFixed(1), y: area.bottom + 14, "text-anchor": "middle" }, label));
    }
    if (this.last) {
      const middle = (area.left + area.right) / 2;
      group.append(svg("text", { x: middle, y: area.bottom + 29, "text-anchor": "middle" }, "time [s]"));
    }
    const middle = (area.top + area.bottom) / 2;
    const turned = `translate(12 ${middle}) rotate(-90)`;
    group.append(svg("text", { transform: turned, "text-anchor": "middle" }, this.title()));
    return group;
  }

  /** Finds a row for the text of each event in sight. */
  placeMarks(view, width) {
    const time = new Scale(view.from, view.to, MARGIN.left, width - MARGIN.right);
    const ends = [];
    const texts = this.events
      .filter(([at]) => at >= view.from && at <= view.to)
      .map(([at, text]) => {
        const [x, length] = [time.at(at), Math.min(text.length * 6.2, 240) + 6];
        const left = x + length > time.to ? x - length : x;
        let row = ends.findIndex((end) => end <= left);
        row = row < 0 ? ends.length : row;
        if (row < 4) {
          ends[row] = left + length;
        }
        return { x: left === x ? x + 3 : x - 3, text, row, anchor: left === x ? "start" : "end" };
      });
    return { rows: ends.length, texts: texts.filter(({ row }) => row < 4) };
  }

  drawMarks({ texts }, area, top) {
    const inSight = this.marks.filter(([at]) => at >= this.time.min && at <= this.time.max);
    const from = this.events.length > 0 ? 2 : area.top;
    const lines = inSight.map(([at, text]) => {
      const d = `M${this.time.at(at).toFixed(1)} ${from}V${area.bottom}`;
      return svg("path", { class: "mark", d }, svg("title", {}, text));
    });
    const labels = texts.map(({ x, text, row, anchor }) => {
      const shown = text.length > 38 ? `${text.slice(0, 37)}\u2026` : text;
      const y = top - 4 - (Math.round((top - MARGIN.top) / MARK_ROW) - 1 - row) * MARK_ROW;
      return svg("text", { class: "mark-text", x: x.toFixed(1), y, "text-anchor": anchor }, shown);
    });
    return [...lines, ...labels];
  }

  cursorLine(view, area) {
    const inSight = view.cursor >= view.from && view.cursor <= view.to;
    const d = inSight ? `M${this.time.at(view.cursor).toFixed(2)} ${area.top}V${area.bottom}` : "";
    return svg("path", { class: "cursor", d });
  }
}

function swatchStyle(color, dash) {
  const paint = `var(--s${color})`;
  const [on, off] = dash.split(" ").map(Number);
  const dashed = `repeating-linear-gradient(90deg, ${paint} 0 ${on}px, transparent ${on}px ${on + off}px)`;
  return `background: ${dash === "" ? paint : dashed}`;
}

/** Real numbers. */
class CurvePanel extends Panel {
  constructor(panel, place) {
    super(panel, place, CURVE_HEIGHT);
  }

  content(view, area) {
    const [from, to] = view.fit ? [view.from, view.to] : [view.begin, view.end];
    const all = this.signals.map(({ signal }) => signal.extremes(from, to));
    let [least, greatest] = [Math.min(...all.map(([low]) => low)), Math.max(...all.map(([, high]) => high))];
    if (!(least <= greatest)) {
      [least, greatest] = [0, 0];
    }
    const size = Math.max(Math.abs(least), Math.abs(greatest));
    const room = greatest - least > size * 1e-9 ? (greatest - least) * 0.06 : size / 10 || 1;
    this.scale = new Scale(least - room, greatest + room, area.bottom, area.top);
    const group = svg("g");
    for (const { value, label } of this.scale.ticks(this.height / 30)) {
      const y = this.scale.at(value);
      const d = `M${area.left} ${y.toFixed(1)}H${area.right}`;
      group.append(svg("path", { class: value === 0 ? "zero" : "grid", d }));
      group.append(svg("text", { x: area.left - 6, y: (y + 4).toFixed(1), "text-anchor": "end" }, label));
    }
    return [group];
  }

  curves(view, area) {
    const most = Math.max(2 * (area.right - area.left), 200);
    return this.signals.map(({ signal, color, dash }) => {
      const level = signal.level(view.from, view.to, most);
      const [line, isBand] = this.curve(level);
      const style = `stroke: var(--s${color}); fill: ${isBand ? `var(--s${color})` : "none"}`;
      const look = isBand ? { class: "band" } : { class: "curve", "stroke-dasharray": dash };
      return svg("path", { ...look, style, "data-signal": signal.name, d: line });
    });
  }

  /** The path of a curve; one whose points stand for several samples is a band from their least to their greatest. */
  curve({ times, low, high, first, last }) {
    const parts = [];
    let back = [];
    let isBand = false;
    const close = () => {
      if (isBand && back.length > 0) {
        parts.push("L", back.reverse().join("L"), "Z");
      }
      back = [];
    };
    let pen = "M";
    for (let index = first; index <= last; index += 1) {
      if (Number.isNaN(low[index])) {
        close();
        pen = "M";
        continue;
      }
      const x = this.time.at(times[index]).toFixed(2);
      parts.push(pen, x, " ", this.scale.at(high[index]).toFixed(2));
      isBand ||= low[index] !== high[index];
      back.push(`${x} ${this.scale.at(low[index]).toFixed(2)}`);
      pen = "L";
    }
    close();
    return [parts.join(""), isBand];
  }

  readout(time) {
    this.signals.forEach(({ signal }, index) => {
      const [low, high] = signal.at(time);
      const same = low === high || Number.isNaN(low);
      const [least, greatest] = [low, high].map((value) => valueText(value, signal.step));
      const number = same ? least : `${least} \u2026 ${greatest}`;
      this.values[index].textContent = signal.unit === "" ? number : `${number} ${signal.unit}`;
    });
  }
}

/** Bits: one lane each, filled while on. */
class LanePanel extends Panel {
  constructor(panel, place) {
    super(panel, place, LANE_HEIGHT * panel.signals.length);
    this.legend.classList.add("lanes");
  }

  content(view, area) {
    const group = svg("g");
    this.signals.forEach((_, index) => {
      const [y, width] = [area.top + index * LANE_HEIGHT, area.right - area.left];
      if (index % 2 === 0) {
        group.append(svg("rect", { class: "shade", x: area.left, y, width, height: LANE_HEIGHT }));
      }
      const d = `M${area.left} ${y + LANE_HEIGHT - 3.5}H${area.right}`;
      group.append(svg("path", { class: "ground", d }));
    });
    return [group];
  }

  curves(view, area) {
    return this.signals.map(({ signal }, lane) => {
      const group = svg("g", { "data-signal": signal.name, style: "fill: var(--s0)" });
      let end = -Infinity;
      for (const { from, to, mixed } of signal.bars(view.from, view.to)) {
        const left = Math.max(this.time.at(from), area.left);
        const right = Math.min(Math.max(this.time.at(to), left + 1), area.right);
        // What lies within the pixel before is not drawn again.
        if (right <= end) {
          continue;
        }
        const x = Math.max(left, end);
        const y = area.top + lane * LANE_HEIGHT + 3.5;
        const size = { x: x.toFixed(2), y, width: (right - x).toFixed(2), height: LANE_HEIGHT - 7 };
        group.append(svg("rect", mixed ? { class: "mixed", ...size } : size));
        end = Math.max(end, right);
      }
      return group;
    });
  }

  readout(time) {
    const words = { 0: "off", 2: "off and on", 3: "on" };
    this.signals.forEach(({ signal }, index) => {
      this.values[index].textContent = words[signal.at(time)] ?? "off";
    });
  }
}
