// The frame strip, zoomable: every frame a bar of its own. The static drawing stays for paper and
// for readers without scripts.
(() => {
  "use strict";
  const box = document.getElementById("frame-strip");
  const frames = JSON.parse(document.getElementById("frame-data").textContent);
  const count = frames.time_ms.length;
  const kHeightPx = 300;
  const fates = { ".": "in time", l: "late", d: "dropped" };

  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const fate = (i) => fates[frames.fate[i]] + (i < frames.warm_up_frames ? ", warm-up" : "");
  const look = (i) =>
    i < frames.warm_up_frames ? "--s9"
      : { ".": "--good", l: "--late", d: "--dropped" }[frames.fate[i]];
  const ms = (value) => (value == null ? "–" : value.toFixed(2) + " ms");

  const budgetLine = (plot) => {
    const y = plot.valToPos(frames.budget_ms, "y", true);
    const { left, top, width, height } = plot.bbox;
    if (y < top || y > top + height) return;
    const pen = plot.ctx;
    pen.save();
    pen.strokeStyle = colour("--budget");
    pen.lineWidth = 1.5 * devicePixelRatio;
    pen.setLineDash([6 * devicePixelRatio, 4 * devicePixelRatio]);
    pen.beginPath();
    pen.moveTo(left, y);
    pen.lineTo(left + width, y);
    pen.stroke();
    pen.font = `600 ${12 * devicePixelRatio}px system-ui, sans-serif`;
    pen.textAlign = "right";
    pen.lineWidth = 4 * devicePixelRatio;
    pen.setLineDash([]);
    pen.strokeStyle = colour("--paper");
    pen.fillStyle = colour("--budget");
    const words = `VSync budget ${frames.budget_ms.toFixed(1)} ms`;
    const at = [words, left + width - 4 * devicePixelRatio, y - 5 * devicePixelRatio];
    pen.strokeText(...at);
    pen.fillText(...at);
    pen.restore();
  };

  const options = () => {
    const axis = { stroke: colour("--soft"), grid: { stroke: colour("--rule"), width: 1 },
                   ticks: { stroke: colour("--rule"), width: 1 } };
    const colours = frames.time_ms.map((_, i) => colour(look(i)));
    const unseen = { paths: () => null, points: { show: false }, scale: "unseen" };
    return {
      width: box.clientWidth,
      height: kHeightPx,
      cursor: { points: { show: false }, y: false },
      scales: {
        x: { time: false, range: (plot, low, high) => [low <= 0 ? -0.5 : low, high >= count - 1 ? count - 0.5 : high] },
        y: { range: (plot, low, high) => [0, 1.08 * Math.max(high || 0, frames.budget_ms)] },
      },
      axes: [{ ...axis, label: "frame", incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1e3, 2e3, 5e3, 1e4, 2e4, 5e4, 1e5] },
             { ...axis, label: "ms" }],
      series: [
        { label: "frame" },
        { label: "time", value: (plot, value) => ms(value), width: 0, fill: colour("--good"),
          points: { show: false },
          paths: uPlot.paths.bars({ size: [0.86, 28],
                                    disp: { fill: { unit: 3, values: () => colours } } }) },
        { ...unseen, label: "fate", value: (plot, value, series, i) => (i == null ? "–" : fate(i)) },
        { ...unseen, label: "motion to photon", value: (plot, value) => ms(value) },
      ],
      hooks: { draw: [budgetLine] },
    };
  };

  // The wheel zooms around the pointer, as maps do.
  const zoomAround = (plot, event) => {
    event.preventDefault();
    const { min, max } = plot.scales.x;
    const at = plot.posToVal(event.offsetX, "x");
    const by = event.deltaY < 0 ? 0.8 : 1.25;
    plot.setScale("x", { min: Math.max(-0.5, at - (at - min) * by),
                         max: Math.min(count - 0.5, at + (max - at) * by) });
  };

  let plot = null;
  const draw = () => {
    const seen = plot && { ...plot.scales.x };
    if (plot) plot.destroy();
    const number = frames.time_ms.map((_, i) => i);
    plot = new uPlot(options(), [number, frames.time_ms, number, frames.motion_to_photon_ms], box);
    plot.over.addEventListener("wheel", (event) => zoomAround(plot, event), { passive: false });
    if (seen) plot.setScale("x", { min: seen.min, max: seen.max });
  };
  draw();
  addEventListener("resize", () => plot.setSize({ width: box.clientWidth, height: kHeightPx }));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  box.parentElement.classList.add("enlivened");
  box.dataset.frames = count;
  box.dataset.mostMs = frames.time_ms.reduce((most, value) => Math.max(most, value ?? 0), 0);
})();
