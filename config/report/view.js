// The land as a block to turn, drawn by three.js. East is x, north y, up z; the block is two
// units long and stands on z = 0.
class View {
  // `turned` is called when the camera has gone round.
  constructor(canvas, context, land, turned) {
    this.canvas = canvas;
    this.turned = turned;
    this.renderer = new THREE.WebGLRenderer({ canvas, context });
    this.camera = new THREE.PerspectiveCamera(26, 1, 0.1, 40);
    this.camera.up.set(0, 0, 1);
    this.scene = new THREE.Scene();

    const { picture, fine } = land;
    this.texture = new THREE.DataTexture(picture, fine.width, fine.height, THREE.RGBAFormat);
    this.texture.magFilter = this.texture.minFilter = THREE.LinearFilter;
    this.texture.anisotropy = this.renderer.capabilities.getMaxAnisotropy();
    const longer = Math.max(land.width, land.height) - 1;
    const scale = 2 / (longer * land.spacing);
    this.scene.add(surfaceOf(land, scale, this.texture));
    this.sides = sidesOf(land, scale);
    this.scene.add(this.sides);

    this.target = new THREE.Vector3(0, 0, 0.35 * scale * (land.high - land.low) + kPlate);
    this.turn = { azimuth: 180, elevation: 36, distance: 5.5 };
    this.listen();
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (!clientWidth || !clientHeight) return;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  // The picture of the land has changed.
  relight(sun) {
    this.texture.needsUpdate = true;
    const colours = this.sides.geometry.attributes.color;
    const rise = Math.sin(sun.elevation * kRadians), flat = Math.cos(sun.elevation * kRadians);
    const ways = [180, 90, 0, 270];  // south, east, north, west
    for (let i = 0; i < colours.count; ++i) {
      const way = ways[Math.floor(i / (colours.count / 4))];
      const facing = Math.max(0, Math.cos((sun.azimuth - way) * kRadians)) * flat;
      const shade = 0.30 + 0.36 * facing / (0.35 + rise);
      colours.setXYZ(i, 1.04 * shade, shade, 0.94 * shade);
    }
    colours.needsUpdate = true;
    this.draw();
  }

  draw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => { this.waiting = false; this.render(); });
  }

  render() {
    const { azimuth, elevation, distance } = this.turn;
    // In a narrow window it stands back; least from above, where no corner is nearer.
    const wide = 1.25 - 0.25 * Math.pow(Math.sin(elevation * kRadians), 8);
    const narrow = Math.max(1, wide / this.camera.aspect);
    const flat = Math.cos(elevation * kRadians) * distance * narrow;
    this.camera.position.set(Math.sin(azimuth * kRadians) * flat, Math.cos(azimuth * kRadians) * flat,
      Math.sin(elevation * kRadians) * distance * narrow).add(this.target);
    this.camera.lookAt(this.target);
    this.turned(azimuth);
    this.renderer.render(this.scene, this.camera);
  }

  move(azimuth, elevation, factor) {
    const turn = this.turn;
    turn.azimuth = (turn.azimuth + azimuth + 720) % 360;
    turn.elevation = Math.min(89.9, Math.max(4, turn.elevation + elevation));
    turn.distance = Math.min(9, Math.max(1.4, turn.distance * factor));
    this.draw();
  }

  look(azimuth, elevation, distance = elevation > 60 ? 4.8 : 5.5) {
    this.canvas.parentElement.classList.add("touched");
    this.turn = { azimuth, elevation, distance };
    this.draw();
  }

  // One pointer turns, two come nearer and tilt: on a phone one finger still scrolls the
  // page up and down.
  listen() {
    const { canvas } = this;
    const pointers = new Map();
    const apart = () => {
      const [a, b] = [...pointers.values()];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    canvas.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      canvas.setPointerCapture(event.pointerId);
      canvas.parentElement.classList.add("touched");
    });
    canvas.addEventListener("pointermove", (event) => {
      const last = pointers.get(event.pointerId);
      if (!last) return;
      const dx = event.clientX - last.x, dy = event.clientY - last.y;
      const before = pointers.size === 2 ? apart() : 0;
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      const degrees = 180 / canvas.clientWidth;
      if (pointers.size === 1) this.move(dx * degrees, dy * degrees, 1);
      if (pointers.size === 2) this.move(0.5 * dx * degrees, 0.5 * dy * degrees, before / Math.max(1, apart()));
    });
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.move(0, 0, Math.exp(0.0012 * event.deltaY));
    }, { passive: false });
    const keys = { ArrowLeft: [-5, 0, 1], ArrowRight: [5, 0, 1], ArrowUp: [0, 4, 1], ArrowDown: [0, -4, 1],
      "+": [0, 0, 0.9], "=": [0, 0, 0.9], "-": [0, 0, 1.1] };
    canvas.addEventListener("keydown", (event) => {
      const by = keys[event.key];
      if (!by) return;
      event.preventDefault();
      this.move(...by);
    });
  }
}

const kPlate = 0.06;  // under the lowest ground

// Every sample to so many a side, then every second, ...: its light has them all, and a
// browser that draws without a graphics card turns it in time.
const kMostCorners = 320;

function surfaceOf(land, scale, texture) {
  const { width, height, heights } = land;
  const stride = Math.ceil(Math.max(width, height) / kMostCorners);
  const chosen = (count) => {
    const at = [];
    for (let i = 0; i < count - 1; i += stride) at.push(i);
    return [...at, count - 1];
  };
  const columns = chosen(width), rows = chosen(height);
  const place = new Float32Array(3 * columns.length * rows.length);
  const at = new Float32Array(2 * columns.length * rows.length);
  let i = 0;
  for (const y of rows)
    for (const x of columns) {
      place[3 * i] = (x - (width - 1) / 2) * land.spacing * scale;
      place[3 * i + 1] = ((height - 1) / 2 - y) * land.spacing * scale;
      place[3 * i + 2] = (heights[y * width + x] - land.low) * scale + kPlate;
      at[2 * i] = (2 * x + 0.5) / land.fine.width;
      at[2 * i + 1] = (2 * y + 0.5) / land.fine.height;
      ++i;
    }
  const corners = new Uint32Array(6 * (columns.length - 1) * (rows.length - 1));
  for (let y = 0, k = 0; y + 1 < rows.length; ++y)
    for (let x = 0; x + 1 < columns.length; ++x) {
      const nw = y * columns.length + x, ne = nw + 1, sw = nw + columns.length, se = sw + 1;
      corners[k++] = nw; corners[k++] = sw; corners[k++] = se;
      corners[k++] = nw; corners[k++] = se; corners[k++] = ne;
    }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(place, 3));
  geometry.setAttribute("uv", new THREE.BufferAttribute(at, 2));
  geometry.setIndex(new THREE.BufferAttribute(corners, 1));
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ map: texture }));
}

// The block's four sides, from the land down to the plate's foot: south, east, north, west.
function sidesOf(land, scale) {
  const { width, height, heights } = land;
  const samples = Math.max(width, height);
  const place = [], corners = [];
  const x = (i) => (i - (width - 1) / 2) * land.spacing * scale;
  const y = (j) => ((height - 1) / 2 - j) * land.spacing * scale;
  const side = (i0, j0, i1, j1) => {
    for (let n = 0; n < samples; ++n) {
      const i = Math.round(i0 + (i1 - i0) * n / (samples - 1));
      const j = Math.round(j0 + (j1 - j0) * n / (samples - 1));
      const top = (heights[j * width + i] - land.low) * scale + kPlate, k = place.length / 3;
      place.push(x(i), y(j), top, x(i), y(j), 0);
      if (n + 1 < samples) corners.push(k, k + 1, k + 3, k, k + 3, k + 2);
    }
  };
  side(0, height - 1, width - 1, height - 1);
  side(width - 1, height - 1, width - 1, 0);
  side(width - 1, 0, 0, 0);
  side(0, 0, 0, height - 1);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(place, 3));
  geometry.setAttribute("color", new THREE.Float32BufferAttribute(new Float32Array(place.length), 3));
  geometry.setIndex(corners);
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ vertexColors: THREE.VertexColors }));
}
