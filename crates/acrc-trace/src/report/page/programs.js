// What the programs did at the cursor, and what they sent.

/** Lines shown before and behind the one at which a program stands. */
const AROUND = 3;
/** Lines of output shown at once. */
const MOST_LINES = 500;

class Program {
  constructor(data, files) {
    Object.assign(this, { name: data.name, places: data.places, entries: data.entries, files });
    let sum = 0;
    this.times = Float64Array.from(data.steps, (step) => (sum += step) / 1e6);
    this.state = html("span", { class: "state" });
    this.where = html("div", { class: "where" });
    this.code = html("div", { class: "code" });
    const heading = html("h3", {}, html("span", {}, data.name), this.state);
    this.element = html("article", { class: "program", "data-program": data.name }, heading, this.where, this.code);
  }

  /** The file, line, statement and state at a time; nothing before it is known. */
  at(time) {
    const index = lastAt(this.times, time);
    return index < 0 ? null : this.places[this.entries[index]];
  }

  draw(time) {
    const place = this.at(time);
    if (place === this.shown) {
      return;
    }
    this.shown = place;
    const [file, line, statement, state] = place ?? [-1, 0, 0, "not known yet"];
    this.state.textContent = state;
    const text = this.files[file];
    const name = text ? `${text.name} ` : "";
    this.where.textContent = place ? `${name}line ${line}, statement ${statement}` : "";
    this.element.dataset.line = String(line);
    this.code.replaceChildren(...this.excerpt(text, line));
  }

  excerpt(text, line) {
    if (!text) {
      return [];
    }
    const first = Math.max(1, line - AROUND);
    const lines = text.lines.slice(first - 1, line + AROUND);
    return lines.map((content, index) => {
      const number = first + index;
      const look = number === line ? { class: "here", "aria-current": "true" } : {};
      return html("div", look, html("span", { class: "number" }, String(number)), content === "" ? " " : content);
    });
  }
}

/** The lines that programs sent within the stretch that is shown. */
class Output {
  constructor(lines, view) {
    this.lines = lines;
    this.view = view;
    this.times = Float64Array.from(lines, ([time]) => time);
    this.body = byId("output").tBodies[0];
    this.rows = [];
  }

  draw() {
    const { from, to, cursor, begin, end } = this.view;
    const key = `${from} ${to}`;
    if (key !== this.key) {
      this.key = key;
      // Rounding must not hide the first and the last line of a run.
      this.first = from <= begin ? 0 : lastAt(this.times, from - 2 * HALF_MICROSECOND) + 1;
      const behind = to >= end ? this.lines.length : lastAt(this.times, to) + 1;
      const shown = this.lines.slice(this.first, Math.min(behind, this.first + MOST_LINES));
      this.rows = shown.map(([time, source, text]) => {
        return html("tr", {}, html("td", {}, moment(this.view, time)), html("td", {}, source), html("td", {}, text));
      });
      this.body.replaceChildren(...this.rows);
      this.count(shown.length, behind - this.first);
    }
    const last = lastAt(this.times, cursor);
    this.rows.forEach((row, index) => row.classList.toggle("past", this.first + index === last));
  }

  count(shown, inSight) {
    const all = this.lines.length;
    const part = shown < inSight ? `the first ${shown} of ${inSight} lines in the stretch that is shown` : `${inSight} lines`;
    const rest = inSight < all ? `, of ${all} in the whole run` : "";
    byId("output-count").textContent = `${part}${rest}`;
  }
}
