// What joins the land, its view and the controls.
(() => {
  const $ = (id) => document.getElementById(id);
  const section = $("land");
  const land = new Land(section.dataset);
  const sun = { azimuth: 0, elevation: 45 };
  const calm = matchMedia("(prefers-reduced-motion: reduce)");

  const say = (sentence) => { $("degraded").textContent = sentence; $("degraded").hidden = false; };

  // From above and flat, where nothing draws in three dimensions.
  const flatView = () => {
    const canvas = $("view");
    canvas.width = land.fine.width;
    canvas.height = land.fine.height;
    canvas.className = "flat";
    canvas.tabIndex = -1;
    canvas.setAttribute("aria-label", "The land from above");
    $("above").parentElement.hidden = $("hint").hidden = true;
    const context = canvas.getContext("2d");
    const image = new ImageData(land.picture, canvas.width, canvas.height);
    return { relight: () => context.putImageData(image, 0, 0) };
  };

  const contextOf = (canvas) => {
    const options = { antialias: true, alpha: true };
    return canvas.getContext("webgl2", options) || canvas.getContext("webgl", options);
  };

  const makeView = () => {
    if (!window.THREE) {
      say("Shown from above only: three.js (package libjs-three) was not installed when this page was made.");
      return flatView();
    }
    const context = contextOf($("view"));
    if (context) return new View($("view"), context, land, turned);
    say("Shown from above only: this browser has no WebGL.");
    return flatView();
  };

  const compass = ["north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west"];
  const matches = [...document.querySelectorAll(".match")].map((element) => ({
    element,
    target: flagsOf(element.dataset.target, land.heights.length),
    window: flagsOf(element.dataset.window, land.heights.length),
    azimuth: +element.dataset.azimuth,
    elevation: +element.dataset.elevation,
  }));

  // The dial lies as the land is seen: what is away from the camera is up.
  let heading = 0;
  const onDial = (azimuth, radius) => {
    const angle = (azimuth - heading) * kRadians;
    return [radius * Math.sin(angle), -radius * Math.cos(angle)];
  };
  const placeOnDial = (element, names, azimuth, radius) => {
    onDial(azimuth, radius).forEach((value, i) => element.setAttribute(names[i], value.toFixed(2)));
  };
  const drawDial = () => {
    placeOnDial($("sun"), ["cx", "cy"], sun.azimuth, 90 - sun.elevation);
    placeOnDial($("ray"), ["x2", "y2"], sun.azimuth, 90 - sun.elevation);
    document.querySelectorAll("#dial text").forEach((text, i) => placeOnDial(text, ["x", "y"], 90 * i, 101));
    $("rose").setAttribute("transform", `rotate(${-heading})`);
  };
  const turned = (azimuth) => { heading = (azimuth + 180) % 360; drawDial(); };

  const view = makeView();

  const show = () => {
    land.light(sun.azimuth, sun.elevation);
    view.relight(sun);
    drawDial();
    $("azimuth").value = sun.azimuth; $("elevation").value = sun.elevation;
    $("azimuth-says").value = `${sun.azimuth.toFixed(0)}° ${compass[Math.round(sun.azimuth / 45) % 8]}`;
    $("elevation-says").value = `${sun.elevation.toFixed(0)}°`;
    for (const match of matches) {
      if (!match.target) continue;
      const overlap = Math.round(100 * land.overlap(match.target, match.window));
      match.element.querySelector("output").value = `${overlap} %`;
      match.element.querySelector(".bar div").style.width = `${overlap}%`;
    }
  };

  let waiting = false, gliding = 0;
  const put = (azimuth, elevation) => {
    sun.azimuth = (azimuth % 360 + 360) % 360;
    sun.elevation = Math.min(89, Math.max(1, elevation));
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => { waiting = false; show(); });
  };
  const putByHand = (azimuth, elevation) => { cancelAnimationFrame(gliding); put(azimuth, elevation); };

  // The short way round, slowly enough to watch the shadows run.
  const glideTo = (azimuth, elevation) => {
    cancelAnimationFrame(gliding);
    if (calm.matches) return put(azimuth, elevation);
    const from = { ...sun }, begin = performance.now();
    const way = ((azimuth - from.azimuth) % 360 + 540) % 360 - 180;
    const glide = (now) => {
      const t = Math.min(1, Math.max(0, (now - begin) / 1600)), eased = t * t * (3 - 2 * t);
      put(from.azimuth + way * eased, from.elevation + (elevation - from.elevation) * eased);
      if (t < 1) gliding = requestAnimationFrame(glide);
    };
    gliding = requestAnimationFrame(glide);
  };

  for (const id of ["azimuth", "elevation"])
    $(id).addEventListener("input", () => putByHand(id === "azimuth" ? +$(id).value : sun.azimuth, id === "elevation" ? +$(id).value : sun.elevation));

  const dial = $("dial");
  const putByDial = (event) => {
    const box = dial.getBoundingClientRect();
    const x = (event.clientX - box.left) / box.width * 224 - 112, y = (event.clientY - box.top) / box.height * 224 - 112;
    putByHand(heading + Math.atan2(x, -y) / kRadians, 90 - Math.hypot(x, y));
  };
  dial.addEventListener("pointerdown", (event) => { dial.setPointerCapture(event.pointerId); putByDial(event); });
  dial.addEventListener("pointermove", (event) => { if (dial.hasPointerCapture(event.pointerId)) putByDial(event); });

  for (const match of matches)
    match.element.querySelector("button").addEventListener("click", () => {
      if (view.look) view.look(180, 89.9);
      glideTo(match.azimuth, match.elevation);
    });
  $("above").addEventListener("click", () => view.look(180, 89.9));
  $("aside").addEventListener("click", () => view.look(sun.azimuth + 115, 24));

  // Not far from the image's sun, but so that it does not show; the camera looks across.
  const away = matches.length ? [75, 14] : [0, 0];
  put(+section.dataset.azimuth + away[0], +section.dataset.elevation + away[1]);
  if (view.turn) view.turn.azimuth = (sun.azimuth + 115) % 360;
  requestAnimationFrame(() => requestAnimationFrame(() => {
    document.documentElement.dataset.ready = Math.round(performance.now());
  }));
})();
