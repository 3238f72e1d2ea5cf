// What the run was: columns of numbers, and the levels of detail in which they are drawn.

/** A column as the page holds it: one number, or whole numbers in base64 with an offset and a step. */
function column(packed, count) {
  if (packed === null || typeof packed === "number") {
    return new Float64Array(count).fill(packed === null ? NaN : packed);
  }
  const bytes = Uint8Array.from(atob(packed.wholes), (letter) => letter.charCodeAt(0));
  const wholes = new DataView(bytes.buffer);
  const noNumber = -(2 ** 31);
  return Float64Array.from({ length: packed.count }, (_, index) => {
    const whole = wholes.getInt32(4 * index, true);
    return whole === noNumber ? NaN : packed.offset + packed.step * whole;
  });
}

/** Times from counts and distances in microseconds in turns. */
function unpackTimes(steps) {
  const times = [];
  let now = 0;
  for (let index = 0; index < steps.length; index += 2) {
    for (let count = steps[index]; count > 0; count -= 1) {
      now += steps[index + 1];
      times.push(now / 1e6);
    }
  }
  return Float64Array.from(times);
}

/** Times are whole microseconds, and the cursor is where it is to within half of one. */
const HALF_MICROSECOND = 5e-7;

/** The index of the last of ascending `times` that is not after `time`; -1 when all are. */
function lastAt(times, time) {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time + HALF_MICROSECOND) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low - 1;
}

/** A signal that takes any number, with its least and greatest values in coarser and coarser levels. */
class Real {
  constructor(data, times) {
    Object.assign(this, { name: data.name, unit: data.unit, group: data.group, source: data.source });
    const low = column(data.real.low, times.length);
    const high = data.real.high === null ? low : column(data.real.high, times.length);
    /** The distance of numbers that the columns can tell apart. */
    this.step = Math.max(...[data.real.low, data.real.high].map((packed) => packed?.step ?? 0));
    this.levels = [{ times, low, high }];
  }

  /** The finest level with at most `most` points between two times, and which of them lie there and next to them. */
  level(from, to, most) {
    for (let index = 0; ; index += 1) {
      const level = this.levels[index];
      const first = Math.max(lastAt(level.times, from), 0);
      const last = Math.min(lastAt(level.times, to) + 1, level.times.length - 1);
      if (last - first <= most || level.times.length <= 2) {
        return { ...level, first, last };
      }
      if (index + 1 === this.levels.length) {
        this.levels.push(coarser(level));
      }
    }
  }

  /** The least and the greatest value at a time. */
  at(time) {
    const { times, low, high } = this.levels[0];
    const index = Math.max(lastAt(times, time), 0);
    return [low[index], high[index]];
  }

  /** The least and the greatest value between two times. */
  extremes(from, to) {
    const { low, high, first, last } = this.level(from, to, 4000);
    let [least, greatest] = [Infinity, -Infinity];
    for (let index = first; index <= last; index += 1) {
      least = low[index] < least ? low[index] : least;
      greatest = high[index] > greatest ? high[index] : greatest;
    }
    return [least, greatest];
  }
}

function coarser({ times, low, high }) {
  const count = Math.ceil(times.length / 2);
  const pick = (values, join) => {
    return Float64Array.from({ length: count }, (_, index) => {
      const [first, second] = [values[2 * index], values[2 * index + 1]];
      return second === undefined || Number.isNaN(second) ? first : Number.isNaN(first) ? second : join(first, second);
    });
  };
  return { times: times.filter((_, index) => index % 2 === 0), low: pick(low, Math.min), high: pick(high, Math.max) };
}

/** A signal that is on or off: the points at which it begins to be something, and what. */
class Bit {
  constructor(data, times, end) {
    Object.assign(this, { name: data.name, unit: "", group: data.group, source: data.source, end });
    const runs = data.bit;
    this.times = Float64Array.from({ length: runs.length / 2 }, (_, index) => times[runs[2 * index]]);
    this.states = Uint8Array.from({ length: runs.length / 2 }, (_, index) => runs[2 * index + 1]);
  }

  /** 0 for off, 3 for on, 2 for both. */
  at(time) {
    const index = Math.max(lastAt(this.times, time), 0);
    return this.states[index] ?? 0;
  }

  /** Where it is on, or both, between two times. */
  bars(from, to) {
    const bars = [];
    for (let index = Math.max(lastAt(this.times, from), 0); index < this.times.length && this.times[index] <= to; index += 1) {
      if (this.states[index] !== 0) {
        bars.push({ from: this.times[index], to: this.times[index + 1] ?? this.end, mixed: this.states[index] === 2 });
      }
    }
    return bars;
  }
}

/** The data of the page, unpacked. */
function readRun() {
  const data = JSON.parse(byId("data").textContent);
  const times = unpackTimes(data.times);
  const signals = data.signals.map((signal) => (signal.bit ? new Bit(signal, times, data.end) : new Real(signal, times)));
  return { ...data, times, signals, begin: times[0] ?? 0 };
}
