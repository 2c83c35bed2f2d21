// The land and how a sun lights it: no part of the page, no library. Heights are metres,
// row 0 is north, x grows east; angles are degrees, azimuth clockwise from north.

const kRadians = Math.PI / 180;
const kSunRadius = 0.265 * kRadians;

// Base64 as bytes.
function bytesOf(text) {
  const binary = atob(text || "");
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

// Base64 of eight flags a byte as one a byte; null for none.
function flagsOf(text, count) {
  const bytes = bytesOf(text);
  if (bytes.length === 0) return null;
  const flags = new Uint8Array(count);
  for (let i = 0; i < count; ++i) flags[i] = bytes[i >> 3] >> (i & 7) & 1;
  return flags;
}

// A field with a sample more between each two, on the two triangles of each square: they
// meet along its diagonal from north-west to south-east, as in the frames.
function doubled(field, width, height) {
  const w = 2 * width - 1, h = 2 * height - 1;
  const fine = new Float32Array(w * h);
  for (let y = 0; y < height; ++y)
    for (let x = 0, i = y * width, k = 2 * y * w; x < width; ++x, ++i, k += 2) {
      fine[k] = field[i];
      if (x + 1 < width) fine[k + 1] = 0.5 * (field[i] + field[i + 1]);
    }
  for (let y = 1; y < h; y += 2)
    for (let x = 0, k = y * w; x < w; ++x, ++k) {
      const east = x & 1;
      fine[k] = 0.5 * (fine[k - w - east] + fine[k + w + east]);
    }
  return { values: fine, width: w, height: h };
}

// The share of the sun's disc that is seen from each sample, into `seen`.
//
// Shadows fall along lines that run from the sun's side over the land, one through each
// sample of the row or column they cross. Along a line a sample lies in shadow where some
// height before it, less what the sun's ray has fallen since, is above it: a running
// maximum, so that all the land costs one pass over it, and is exact to a sample.
function castShadows(heights, width, height, spacing, azimuth, elevation, seen) {
  const east = Math.sin(azimuth * kRadians), south = -Math.cos(azimuth * kRadians);
  const byColumns = Math.abs(east) >= Math.abs(south);
  // `along` the lines, from the sun's side on; `across` them.
  const count = byColumns ? width : height, across = byColumns ? height : width;
  const stepAlong = byColumns ? 1 : width, stepAcross = byColumns ? width : 1;
  const major = byColumns ? east : south, minor = byColumns ? south : east;
  const first = major > 0 ? count - 1 : 0, direction = major > 0 ? -1 : 1;
  const drift = -minor / Math.abs(major);  // samples across, a step along
  const step = spacing * Math.hypot(1, drift);
  const tangent = Math.tan(elevation * kRadians);
  const fall = step * tangent;
  // How the disc's rim moves up and down at a distance; at least half a sample is soft.
  const softness = kSunRadius * (1 + tangent * tangent), least = 0.5 * fall;

  const shift = drift * (count - 1);
  const lowest = Math.floor(Math.min(0, -shift)) - 1;
  const lines = Math.ceil(across - 1 + Math.max(0, -shift)) + 2 - lowest;
  const tops = new Float64Array(lines).fill(-1e9);  // the highest so far, as at step 0
  const since = new Float64Array(lines);            // the step at which that was
  for (let i = 0; i < count; ++i) {
    const origin = (first + direction * i) * stepAlong;
    const offset = -drift * i - lowest;  // of sample 0 among the lines
    const risen = i * fall;
    for (let j = 0, k = origin; j < across; ++j, k += stepAcross) {
      const at = j + offset, line = Math.floor(at), part = at - line;
      const top = tops[line] + part * (tops[line + 1] - tops[line]) - risen;
      const away = i - (part < 0.5 ? since[line] : since[line + 1]);
      const soft = Math.max(least, away * step * softness);
      const share = 0.5 + 0.5 * (heights[k] - top) / soft;
      seen[k] = share > 1 ? 1 : share < 0 ? 0 : share;
    }
    // Lines that lie on the land here see its height between two samples.
    const begin = Math.max(0, Math.ceil(offset));
    const end = Math.min(lines - 1, Math.floor(across - 1 + offset));
    for (let line = begin; line <= end; ++line) {
      const at = line - offset, j = Math.min(Math.floor(at), across - 2), part = at - j;
      const k = origin + j * stepAcross;
      const value = heights[k] + part * (heights[k + stepAcross] - heights[k]) + risen;
      if (value > tops[line]) { tops[line] = value; since[line] = i; }
    }
  }
}

class Land {
  constructor(data) {
    this.width = +data.columns; this.height = +data.lines; this.spacing = +data.spacing;
    this.low = +data.low; this.high = +data.high;
    const levels = bytesOf(data.heights), scale = (this.high - this.low) / 65535;
    const count = this.width * this.height;
    this.heights = new Float32Array(count);
    for (let i = 0; i < count; ++i)
      this.heights[i] = this.low + scale * (levels[2 * i] | levels[2 * i + 1] << 8);
    this.water = flagsOf(data.water, count);
    this.fine = doubled(this.heights, this.width, this.height);
    this.seen = new Float32Array(this.fine.values.length);
    this.picture = new Uint8ClampedArray(4 * this.seen.length);
    this.prepareNormals();
    this.prepareColours();
  }

  // Unit normals: east, south, up.
  prepareNormals() {
    const { width, height, heights, spacing } = this;
    const slopes = [new Float32Array(heights.length), new Float32Array(heights.length)];
    for (let y = 0, i = 0; y < height; ++y)
      for (let x = 0; x < width; ++x, ++i) {
        const w = x > 0 ? 1 : 0, e = x + 1 < width ? 1 : 0;
        const n = y > 0 ? width : 0, s = y + 1 < height ? width : 0;
        slopes[0][i] = (heights[i + e] - heights[i - w]) / (Math.max(1, w + e) * spacing);
        slopes[1][i] = (heights[i + s] - heights[i - n]) / (Math.max(1, (n + s) / width) * spacing);
      }
    const [east, south] = slopes.map((slope) => doubled(slope, width, height).values);
    const up = new Float32Array(east.length);
    for (let i = 0; i < up.length; ++i) {
      const length = 1 / Math.sqrt(1 + east[i] * east[i] + south[i] * south[i]);
      east[i] *= -length; south[i] *= -length; up[i] = length;
    }
    this.normals = { east, south, up };
  }

  // What each sample sees of the sky (a few suns stand for it), and the ground's colour:
  // pale stone, greyer where it is steep; water darker. Both linear.
  prepareColours() {
    const { width, height } = this;
    const open = new Float32Array(this.heights.length);
    const seen = new Float32Array(open.length);
    for (let azimuth = 30; azimuth < 360; azimuth += 60) {
      const elevation = azimuth % 120 < 60 ? 14 : 34;
      castShadows(this.heights, width, height, this.spacing, azimuth, elevation, seen);
      for (let i = 0; i < open.length; ++i) open[i] += seen[i] / 6;
    }
    this.open = doubled(open, width, height).values;
    const wet = this.water ? doubled(this.water, width, height).values : null;
    const stone = [0.60, 0.545, 0.47], cliff = [0.40, 0.375, 0.35], lake = [0.10, 0.19, 0.26];
    this.albedo = new Float32Array(3 * this.open.length);
    for (let i = 0, k = 0; i < this.open.length; ++i) {
      const up = this.normals.up[i], steep = Math.min(1, Math.max(0, (0.94 - up) / 0.25));
      for (let c = 0; c < 3; ++c, ++k) {
        let colour = stone[c] + steep * (cliff[c] - stone[c]);
        if (wet) colour += wet[i] * (lake[c] - colour);
        this.albedo[k] = colour;
      }
    }
  }

  // Draws the land from above as this sun lights it into `picture`, RGBA, exposed for it.
  light(azimuth, elevation) {
    const { fine, seen, normals, open, albedo, picture } = this;
    castShadows(fine.values, fine.width, fine.height, this.spacing / 2, azimuth, elevation, seen);
    const rise = Math.sin(elevation * kRadians), flat = Math.cos(elevation * kRadians);
    const east = Math.sin(azimuth * kRadians) * flat, south = -Math.cos(azimuth * kRadians) * flat;
    // Low suns are warm; level ground is as bright under all of them.
    const warmth = Math.exp(-rise * 5);
    const exposure = 1.12 / (0.24 + 0.9 * Math.pow(rise, 0.7));
    const sun = [1.15, 1.15 - 0.30 * warmth, 1.13 - 0.62 * warmth].map((c) => c * exposure);
    const sky = [0.15, 0.185, 0.25].map((c) => c * exposure * (0.35 + 0.65 * Math.pow(rise, 0.7)));
    for (let i = 0, k = 0, c = 0; i < seen.length; ++i, k += 4, c += 3) {
      const facing = normals.east[i] * east + normals.south[i] * south + normals.up[i] * rise;
      const direct = facing > 0 ? facing * seen[i] : 0;
      const ambient = open[i] * open[i] * (0.5 + 0.5 * normals.up[i]);
      picture[k] = displayed(albedo[c] * (direct * sun[0] + ambient * sky[0]));
      picture[k + 1] = displayed(albedo[c + 1] * (direct * sun[1] + ambient * sky[1]));
      picture[k + 2] = displayed(albedo[c + 2] * (direct * sun[2] + ambient * sky[2]));
      picture[k + 3] = 255;
    }
  }

  // Of the samples that are dark in the image or in the land's shadow, the share that is
  // dark in both; where `window` says, null: everywhere. Of the last sun.
  overlap(target, window) {
    let both = 0, either = 0;
    for (let y = 0, i = 0; y < this.height; ++y)
      for (let x = 0, k = 2 * y * this.fine.width; x < this.width; ++x, ++i, k += 2) {
        if (window && !window[i]) continue;
        const dark = this.seen[k] < 0.5;
        if (dark && target[i]) ++both;
        if (dark || target[i]) ++either;
      }
    return either > 0 ? both / either : 0;
  }
}

// Linear 0 to 1 and above as a display shows it: rolled off, then the curve of sRGB.
const kDisplay = new Uint8Array(4096);
for (let i = 0; i < 4096; ++i) {
  const x = i / 1024, rolled = x * (1 + x / 6) / (1 + x * 0.75);
  kDisplay[i] = 255 * Math.min(1, rolled < 0.0031308 ? 12.92 * rolled : 1.055 * Math.pow(rolled, 1 / 2.4) - 0.055);
}
function displayed(linear) {
  return kDisplay[Math.min(4095, linear * 1024 | 0)];
}
