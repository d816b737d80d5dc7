// The moment that is shown, and how it moves on: play, pause, rewind, speed, frame by frame.

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16];
const FAST = 4;

class Player {
  constructor(recording) {
    this.recording = recording;
    this.place = 0;
    this.playing = false;
    this.direction = 1;
    this.speed = 1;
    this.winding = 1;
    this.jumped = true;
  }

  /** How many ticks a second of the wall clock brings, with its sign. */
  get rate() {
    return (this.direction * this.speed * this.winding) / this.recording.tickSeconds;
  }

  /** Whether the next picture differs from this one. */
  get moves() {
    return this.playing;
  }

  seek(place) {
    this.place = Maths.clamp(place, 0, this.recording.last);
    this.jumped = true;
  }

  /** Play on, or pause; at the end, play from the start. */
  toggle() {
    const winding = this.playing && (this.direction < 0 || this.winding > 1);
    if (this.playing && !winding) return this.pause();
    if (!this.playing && this.place >= this.recording.last) this.seek(0);
    this.start(1, 1);
  }

  start(direction, winding) {
    this.playing = true;
    this.direction = direction;
    this.winding = winding;
  }

  pause() {
    this.playing = false;
    this.direction = 1;
    this.winding = 1;
    this.place = Math.round(this.place);
  }

  /** Wind forward or backward: faster than playing; again: back to a pause. */
  wind(direction) {
    if (this.playing && this.direction === direction && (direction < 0 || this.winding > 1)) this.pause();
    else this.start(direction, direction < 0 && this.speed < 1 ? 1 : FAST);
  }

  frames(count) {
    this.pause();
    this.seek(this.place + count);
  }

  seconds(count) {
    this.seek(Math.round(this.place + count / this.recording.tickSeconds));
  }

  faster(steps) {
    const at = SPEEDS.indexOf(this.speed);
    this.speed = SPEEDS[Maths.clamp(at + steps, 0, SPEEDS.length - 1)];
  }

  advance(seconds) {
    if (!this.playing) return;
    this.place += this.rate * seconds;
    if (this.place <= 0 || this.place >= this.recording.last) {
      this.place = Maths.clamp(this.place, 0, this.recording.last);
      this.pause();
    }
  }
}
