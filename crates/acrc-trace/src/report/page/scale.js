// From values to pixels, and round numbers along an axis.

/** A linear scale. */
class Scale {
  constructor(min, max, from, to) {
    Object.assign(this, { min, max, from, to });
  }

  at(value) {
    return this.from + ((value - this.min) / (this.max - this.min)) * (this.to - this.from);
  }

  /** The value at a pixel. */
  value(pixel) {
    return this.min + ((pixel - this.from) / (this.to - this.from)) * (this.max - this.min);
  }

  /** About `count` labelled places: multiples of 1, 2 or 5 times a power of ten. */
  ticks(count) {
    const size = (this.max - this.min) / Math.max(count, 1);
    const decade = 10 ** Math.floor(Math.log10(size));
    const step = decade * ([1, 2, 5].find((factor) => factor * decade >= size * 0.999) ?? 10);
    const [first, last] = [Math.ceil(this.min / step - 1e-9), Math.floor(this.max / step + 1e-9)];
    const largest = Math.max(Math.abs(this.min), Math.abs(this.max));
    const multiples = Array.from({ length: Math.min(Math.max(last - first + 1, 0), 100) }, (_, index) => first + index);
    return multiples.map((multiple) => ({ value: multiple * step, label: tickLabel(multiple * step, step, largest) }));
  }
}

function tickLabel(value, step, largest) {
  if (value === 0) {
    return "0";
  }
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  if (largest >= 1e6 || decimals > 6) {
    const digits = Math.max(0, Math.floor(Math.log10(largest)) - Math.floor(Math.log10(step) + 1e-9));
    return minus(value.toExponential(Math.min(digits, 9)).replace("e+", "e"));
  }
  return minus(value.toFixed(decimals));
}

/** The true minus sign is as wide as a digit. */
function minus(text) {
  return text.replace(/^-/, "\u2212");
}

/** A value with at most seven digits, and none beyond those that its column can tell apart. */
function valueText(value, step = 0) {
  if (!Number.isFinite(value)) {
    return "\u2013";
  }
  const decimals = step > 0 ? Math.floor(-Math.log10(step)) : 100;
  const known = decimals >= 0 && decimals < 100 ? Number(value.toFixed(decimals)) : value;
  const rounded = Number(known.toPrecision(7));
  return minus(String(rounded === 0 ? 0 : rounded));
}

/** A time in seconds, to the microsecond, without zeros that say nothing. */
function seconds(time) {
  return `${Number(time.toFixed(6))} s`;
}
