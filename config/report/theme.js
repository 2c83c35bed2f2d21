// Before anything is drawn: the theme that the reader chose last, else the system's.
try {
  const chosen = localStorage.getItem("cydonia-theme");
  if (chosen === "light" || chosen === "dark") document.documentElement.dataset.theme = chosen;
} catch (forbidden) {}

addEventListener("DOMContentLoaded", () => {
  const root = document.documentElement;
  const button = document.getElementById("theme");
  const systems = matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => (root.dataset.theme || (systems.matches ? "dark" : "light")) === "dark";
  const label = () => { button.textContent = isDark() ? "Light" : "Dark"; };
  button.hidden = false;
  button.setAttribute("aria-label", "Change between light and dark");
  button.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    try { localStorage.setItem("cydonia-theme", root.dataset.theme); } catch (forbidden) {}
    label();
  });
  systems.addEventListener("change", label);
  label();
});
