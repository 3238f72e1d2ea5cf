// The paths of tools: one signal over another, both to one scale, with the part in sight and the place at the cursor.

const PATH_HEIGHT = 340;

class Path {
  constructor(data) {
    this.names = data.names;
    this.units = data.units;
    this.times = unpackTimes(data.times);
    [this.x, this.y] = [data.x, data.y].map((part) => column(part, this.times.length));
    const label = `${data.names[1]} over ${data.names[0]}`;
    this.svg = svg("svg", { role: "img", "aria-label": label });
    this.element = html("figure", { class: "path" }, this.svg);
  }

  /** Whether there is anything to see. */
  moves() {
    const changes = (values) => values.some((value) => value !== values[0] && !Number.isNaN(value));
    return changes(this.x) || changes(this.y);
  }

  draw(view, width) {
    const area = { left: MARGIN.left, right: width - MARGIN.right, top: 8, bottom: 8 + PATH_HEIGHT };
    if (width !== this.width) {
      this.width = width;
      this.place(area);
      this.all = this.line(0, this.times.length - 1);
    }
    const height = area.bottom + 36;
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const [first, last] = [view.from, view.to].map((time) => Math.max(lastAt(this.times, time), 0));
    this.svg.replaceChildren(
      svg("rect", { class: "area", x: area.left, y: area.top, width: area.right - area.left, height: PATH_HEIGHT }),
      this.axes(area),
      svg("path", { class: "path-all", d: this.all }),
      svg("path", { class: "path-shown", d: this.line(first, last) }),
      this.dot(view.cursor),
    );
  }

  place(area) {
    const range = (values) => {
      let [least, greatest] = [Infinity, -Infinity];
      for (const value of values) {
        least = value < least ? value : least;
        greatest = value > greatest ? value : greatest;
      }
      return least <= greatest ? [least, greatest] : [0, 0];
    };
    const [width, height] = [area.right - area.left, area.bottom - area.top];
    const [across, up] = [range(this.x), range(this.y)];
    const scale = 1.12 * Math.max((across[1] - across[0]) / width, (up[1] - up[0]) / height) || 1;
    const [x, y] = [(across[0] + across[1]) / 2, (up[0] + up[1]) / 2];
    this.across = new Scale(x - (scale * width) / 2, x + (scale * width) / 2, area.left, area.right);
    this.up = new Scale(y - (scale * height) / 2, y + (scale * height) / 2, area.bottom, area.top);
  }

  axes(area) {
    const group = svg("g");
    const title = (index) => (this.units[index] === "" ? this.names[index] : `${this.names[index]} [${this.units[index]}]`);
    for (const { value, label } of this.across.ticks((area.right - area.left) / 90)) {
      const x = this.across.at(value).toFixed(1);
      group.append(svg("path", { class: "grid", d: `M${x} ${area.top}V${area.bottom}` }));
      group.append(svg("text", { x, y: area.bottom + 14, "text-anchor": "middle" }, label));
    }
    for (const { value, label } of this.up.ticks(PATH_HEIGHT / 45)) {
      const y = this.up.at(value);
      group.append(svg("path", { class: "grid", d: `M${area.left} ${y.toFixed(1)}H${area.right}` }));
      group.append(svg("text", { x: area.left - 6, y: (y + 4).toFixed(1), "text-anchor": "end" }, label));
    }
    const middle = { x: (area.left + area.right) / 2, y: (area.top + area.bottom) / 2 };
    group.append(svg("text", { x: middle.x, y: area.bottom + 30, "text-anchor": "middle" }, title(0)));
    const turned = `translate(12 ${middle.y}) rotate(-90)`;
    group.append(svg("text", { transform: turned, "text-anchor": "middle" }, title(1)));
    return group;
  }

  /** The path between two samples, without points that would not be seen. */
  line(first, last) {
    const parts = [];
    let [pen, before] = ["M", [NaN, NaN]];
    for (let index = first; index <= last; index += 1) {
      const [x, y] = [this.across.at(this.x[index]), this.up.at(this.y[index])];
      if (Number.isNaN(x) || Number.isNaN(y)) {
        pen = "M";
        continue;
      }
      if (pen === "L" && index < last && Math.hypot(x - before[0], y - before[1]) < 0.5) {
        continue;
      }
      parts.push(`${pen}${x.toFixed(1)} ${y.toFixed(1)}`);
      [pen, before] = ["L", [x, y]];
    }
    return parts.join("");
  }

  dot(time) {
    const index = Math.max(lastAt(this.times, time), 0);
    const [x, y] = [this.x[index], this.y[index]];
    if (Number.isNaN(x) || Number.isNaN(y)) {
      return svg("g");
    }
    const about = `${valueText(x)}, ${valueText(y)}`;
    return svg("circle", { class: "cursor-dot", cx: this.across.at(x), cy: this.up.at(y), r: 5 }, svg("title", {}, about));
  }
}
