// Looks at a report in headless Chromium and prints what it found as JSON:
//   node report.js PAGE [FOLDER FOR SCREENSHOTS]
"use strict";
const { Browser } = require("./chromium.js");
const path = require("path");

const overlap = "document.querySelector('.match output')?.value ?? ''";

// How the page behaves when its sun is moved and its image asked for.
async function use(page) {
  const seen = () => page.screenshot("/dev/null", "#view");
  // On a busy machine a canvas may be composed late and once more: what must hold is that
  // the view comes to rest, a second long, within twenty.
  const settled = async () => {
    await page.drawn();
    let last = await seen();
    for (let look = 0, alike = 0; look < 80; ++look) {
      await new Promise((done) => setTimeout(done, 250));
      const next = await seen();
      alike = next === last ? alike + 1 : 0;
      last = next;
      if (alike === 4) return { picture: last, rests: true };
    }
    return { picture: last, rests: false };
  };
  const first = await settled();
  await page.value("document.querySelector('.match') && document.querySelector('.match').scrollIntoView()");
  const before = await page.value(overlap);
  await page.value("(() => { const s = document.getElementById('azimuth'); s.value = (+s.value + 120) % 360; s.dispatchEvent(new Event('input')); })()");
  const moved = await settled();
  await page.value("document.querySelector('.match button')?.click()");
  const calm = await page.value("matchMedia('(prefers-reduced-motion: reduce)').matches");
  await new Promise((done) => setTimeout(done, calm ? 100 : 2500));
  await page.drawn();
  return {
    steady: first.rests && moved.rests, moves: first.picture !== moved.picture, before, found: await page.value(overlap),
    says: await page.value("document.getElementById('degraded').textContent"),
  };
}

// How much longer the shadow of a block is than height / tan(elevation), at most, in
// samples, under suns all around; run in the page.
function worstShadow() {
  const width = 160, height = 140, block = [74, 66, 11], high = 12, spacing = 2;
  const heights = new Float32Array(width * height), seen = new Float32Array(width * height);
  const each = (act) => {
    for (let y = 0, i = 0; y < height; ++y) for (let x = 0; x < width; ++x, ++i) act(x, y, i);
  };
  const isBlock = (x, y) => x >= block[0] && y >= block[1] && x < block[0] + block[2] && y < block[1] + block[2];
  each((x, y, i) => { heights[i] = isBlock(x, y) ? high : 0; });
  let worst = 0;
  for (let azimuth = 0; azimuth < 360; azimuth += 15)
    for (const elevation of [15, 40]) {
      castShadows(heights, width, height, spacing, azimuth, elevation, seen);
      const east = Math.sin(azimuth * kRadians), south = -Math.cos(azimuth * kRadians);
      const away = (x, y) => -(east * x + south * y);
      let edge = -1e9, end = -1e9;
      each((x, y, i) => {
        if (isBlock(x, y)) edge = Math.max(edge, away(x, y));
        else if (seen[i] < 0.5) end = Math.max(end, away(x, y));
      });
      const length = high / spacing / Math.tan(elevation * kRadians);
      worst = Math.max(worst, Math.abs(end - edge - length));
    }
  return worst;
}

(async () => {
  const [file, folder] = process.argv.slice(2);
  const shot = async (page, name, selector) => {
    if (!folder) return;
    await page.value("Promise.all([...document.images].map(i => { i.loading = 'eager'; return i.decode(); }))");
    await page.screenshot(path.join(folder, name + ".png"), selector);
  };
  const told = {};
  let browser = new Browser();
  try {
    let page = await browser.open(file);
    told.title = await page.value("document.title");
    told.ready = +await page.value("document.documentElement.dataset.ready");
    await shot(page, "light", "html");
    told.webgl = await use(page);
    told.wall = await page.value(`(${worstShadow})()`);
    await shot(page, "found", "#land");
    told.errors = page.errors;
    told.requests = page.requests;
    page = await browser.open(file, { scheme: "dark" });
    await shot(page, "dark", "html");
    told.dark = await page.value("getComputedStyle(document.body).backgroundColor");
    await page.value("document.getElementById('theme').click()");
    told.switched = await page.value("getComputedStyle(document.body).backgroundColor");
    page = await browser.open(file, { width: 390, height: 844, scale: 2, mobile: true });
    told.phone = await page.value("document.documentElement.scrollWidth");
    await shot(page, "phone", "html");
    browser.close();

    browser = new Browser(["--disable-3d-apis"]);
    page = await browser.open(file);
    told.flat = await use(page);
    told.flat.errors = page.errors;
    await shot(page, "flat", "#land");
  } finally {
    browser.close();
  }
  console.log(JSON.stringify(told, null, 1));
})().catch((error) => { console.error(error); process.exit(1); });
