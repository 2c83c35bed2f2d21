#!/bin/bash
# The report of the demo at draft quality, 512x512 samples: its size, how long it took to
# write, and milliseconds from opening it in headless Chromium until the land has been
# drawn under its first sun (least of five; drawn without a graphics card).
set -euo pipefail
cd "$(dirname "$0")/.."

cydonia=${CYDONIA:-./cydonia}
"$cydonia" --version # builds it when needed
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$cydonia" render scenes/text/scene.toml --quality draft --quiet -o "$out"
"$cydonia" info "$out/manifest.json" | awk '$1 == "report" { print "written in", $2, $3 }'
stat -c 'size %s bytes' "$out/report.html"

for program in chromium node; do
    if ! command -v "$program" >/dev/null; then
        echo "time to interactive: skipped, $program is not installed"
        exit
    fi
done
node - "$out/report.html" <<'END'
const { Browser } = require("./tests/e2e/chromium.js");
(async () => {
  const browser = new Browser();
  const times = [];
  try {
    for (let i = 0; i < 5; ++i) {
      const page = await browser.open(process.argv[2]);
      times.push(+await page.value("document.documentElement.dataset.ready"));
    }
  } finally {
    browser.close();
  }
  console.log(`interactive after ${Math.min(...times)} ms (${times.join(", ")})`);
})().catch((error) => { console.error(error); process.exit(1); });
END
