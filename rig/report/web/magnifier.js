// A lens over the pictures of one eye: the same place in all of them at once, as rendered, in full,
// where rays went.
(() => {
  "use strict";
  const kZoom = 4;
  const kShareOfWidth = 0.42;

  for (const row of document.querySelectorAll(".gallery")) {
    const stacks = [...row.querySelectorAll("figure.eye:not(.magnified) .stack")];
    const lenses = stacks.map((stack) => {
      const lens = document.createElement("div");
      lens.className = "lens";
      for (const image of stack.querySelectorAll("img")) lens.append(image.cloneNode());
      stack.append(lens);
      return lens;
    });
    const look = (x, y) => {
      lenses.forEach((lens, i) => {
        const { width, height } = stacks[i].getBoundingClientRect();
        const size = width * kShareOfWidth;
        lens.style.cssText = `width:${size}px;height:${size}px;` +
          `left:${x * width - size / 2}px;top:${y * height - size / 2}px;display:block`;
        for (const image of lens.children) {
          image.style.cssText = `width:${width * kZoom}px;height:${height * kZoom}px;` +
            `left:${size / 2 - x * width * kZoom}px;top:${size / 2 - y * height * kZoom}px`;
        }
      });
    };
    stacks.forEach((stack) => {
      stack.addEventListener("pointermove", (event) => {
        const box = stack.getBoundingClientRect();
        look((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
      });
      stack.addEventListener("pointerleave", () => lenses.forEach((lens) => (lens.style.display = "none")));
    });
  }
})();
