// Reading what the page carries: facts as JSON, one block of packed numbers for each half.
// A block is zlib over, for each channel and entity, the low bytes and then the high bytes of the differences of
// differences of int16 numbers: motion is smooth, so nearly all of these bytes are small.

const Embedded = {
  async recording() {
    const facts = JSON.parse(document.getElementById("facts").textContent);
    const halves = [];
    for (const half of facts.halves) {
      const bytes = await Embedded.inflate(document.getElementById(`half-${half.half}`).textContent);
      halves.push(Embedded.half(facts, half, bytes));
    }
    return new Recording(facts, halves);
  },

  async inflate(text) {
    const packed = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  },

  half(facts, half, bytes) {
    const frames = half.ticks + 1;
    const channels = {};
    let first = 0;
    for (const channel of facts.channels) {
      channels[channel.name] = facts.entities.map(() => {
        const numbers = Embedded.column(bytes, first, frames);
        first += 2 * frames;
        return numbers;
      });
    }
    if (first !== bytes.length) throw new Error("the recorded poses are not complete");
    const units = Object.fromEntries(facts.channels.map((channel) => [channel.name, channel.unit]));
    return new HalfTrack(half, channels, units, facts.entities);
  },

  /** One column of int16 numbers; sums wrap round as int16 do, which is also how angles wrap. */
  column(bytes, first, frames) {
    const numbers = new Int16Array(frames);
    let step = 0, value = 0;
    for (let row = 0; row < frames; row++) {
      step = ((step + (bytes[first + row] | (bytes[first + frames + row] << 8))) << 16) >> 16;
      value = ((value + step) << 16) >> 16;
      numbers[row] = value;
    }
    return numbers;
  },
};
