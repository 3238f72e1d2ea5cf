// What is shown: a stretch of time and a cursor. The address of the page keeps both.

/** The shortest stretch that is shown, in seconds. */
const SHORTEST = 1e-4;

class View {
  constructor(begin, end) {
    this.begin = begin;
    this.end = Math.max(end, begin + SHORTEST);
    this.listeners = [];
    this.fit = false;
    this.from = this.begin;
    this.to = this.end;
    this.cursor = this.begin;
    this.readAddress();
    window.addEventListener("hashchange", () => this.readAddress());
  }

  /** Calls a function now and whenever something has changed. */
  follow(listener) {
    this.listeners.push(listener);
    listener();
  }

  tell() {
    this.listeners.forEach((listener) => listener());
  }

  /** Something is different: the page says so at once, and is drawn with the next frame. */
  change() {
    const main = document.querySelector("main");
    const rounded = (time) => String(Number(time.toFixed(6)));
    Object.assign(main.dataset, { from: rounded(this.from), to: rounded(this.to), cursor: rounded(this.cursor) });
    clearTimeout(this.writing);
    this.writing = setTimeout(() => this.writeAddress(), 200);
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.tell());
  }

  setRange(from, to) {
    const size = Math.min(Math.max(to - from, SHORTEST), this.end - this.begin);
    this.from = Math.min(Math.max(from, this.begin), this.end - size);
    this.to = this.from + size;
    this.change();
  }

  setCursor(time) {
    this.cursor = Math.min(Math.max(time, this.begin), this.end);
    this.change();
  }

  /** Moves the cursor, and the stretch with it where the cursor would be outside. */
  show(time) {
    this.setCursor(time);
    const size = this.to - this.from;
    if (this.cursor < this.from || this.cursor > this.to) {
      this.setRange(this.cursor - size / 2, this.cursor + size / 2);
    }
  }

  /** Shows `factor` times as much time, with `time` where it is. */
  zoom(factor, time = this.anchor()) {
    const part = (time - this.from) / (this.to - this.from);
    const size = Math.min(Math.max((this.to - this.from) * factor, SHORTEST), this.end - this.begin);
    this.setRange(time - part * size, time - part * size + size);
  }

  /** Moves by a part of what is shown. */
  pan(part) {
    const step = part * (this.to - this.from);
    this.setRange(this.from + step, this.to + step);
  }

  whole() {
    this.setRange(this.begin, this.end);
  }

  /** The cursor where it is in sight, else the middle. */
  anchor() {
    const inSight = this.cursor >= this.from && this.cursor <= this.to;
    return inSight ? this.cursor : (this.from + this.to) / 2;
  }

  readAddress() {
    const fields = new URLSearchParams(location.hash.slice(1));
    const time = (name, otherwise) => {
      const value = fields.get(name);
      return value !== null && value.trim() !== "" && Number.isFinite(Number(value)) ? Number(value) : otherwise;
    };
    this.setRange(time("from", this.begin), time("to", this.end));
    this.setCursor(time("at", this.cursor));
  }

  writeAddress() {
    const fields = new URLSearchParams();
    const add = (name, time) => fields.set(name, String(Number(time.toFixed(6))));
    if (this.from > this.begin + SHORTEST / 2 || this.to < this.end - SHORTEST / 2) {
      add("from", this.from);
      add("to", this.to);
    }
    add("at", this.cursor);
    try {
      history.replaceState(null, "", `#${fields}`);
    } catch {
      // A page inside another one may have no address of its own.
    }
  }
}
