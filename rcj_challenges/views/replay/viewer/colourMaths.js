// Colours as numbers: any colour that CSS knows, because scenarios may name any.

const Colours = {
  memory: new Map(),

  /** [red, green, blue] from 0 to 1 of a CSS colour; grey for what is none. */
  rgb(css) {
    let found = Colours.memory.get(css);
    if (!found) {
      const context = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
      context.fillStyle = "#868e96";
      context.fillStyle = css;
      context.fillRect(0, 0, 1, 1);
      found = [...context.getImageData(0, 0, 1, 1).data].slice(0, 3).map((part) => part / 255);
      Colours.memory.set(css, found);
    }
    return found;
  },

  css: ([red, green, blue], alpha = 1) =>
    `rgba(${Math.round(red * 255)}, ${Math.round(green * 255)}, ${Math.round(blue * 255)}, ${alpha})`,

  mix: (a, b, share) => a.map((part, index) => Maths.mix(part, b[index], share)),

  /** Black or white, whichever can be read on a colour (relative luminance as in WCAG 2). */
  onTop(rgb) {
    const [red, green, blue] = rgb.map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue > 0.3 ? "#10151c" : "#ffffff";
  },
};

/** The colours of views/palette.py (`PALETTE_CSS` stands before the first part of the script) as numbers. */
const PALETTE = (() => {
  const numbers = (css) => {
    if (typeof css === "string") return Colours.rgb(css);
    return Array.isArray(css) ? css.map(numbers) : Object.fromEntries(Object.entries(css).map(([name, one]) => [name, numbers(one)]));
  };
  return numbers(PALETTE_CSS);
})();
