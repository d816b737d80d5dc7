// Logos of teams: on the scoreboard, and on the lids of the robots that a team drives in the half that is shown.

class Logos {
  constructor(recording, rows, changed) {
    this.recording = recording;
    this.pictures = new Map();
    this.memory = new Map();
    for (const { team, row } of rows) {
      if (!team.logo) continue;
      const picture = new Image();
      picture.className = "logo";
      picture.alt = "";
      picture.src = team.logo;
      picture.decode().then(() => {
        this.pictures.set(team.name, picture);
        this.memory.clear();
        row.querySelector(".name").before(picture);
        changed();
      }).catch(() => console.info("a logo cannot be shown"));
    }
  }

  /** The picture of each entity, or undefined; the same array as long as nothing changed. */
  at(place) {
    const { facts } = this.recording.at(place).track;
    let found = this.memory.get(facts.half);
    if (!found) {
      found = this.recording.entities.map((entity) => this.pictures.get(facts.sides[entity.seat]));
      this.memory.set(facts.half, found);
    }
    return found;
  }

  /** Draw a picture into a square with white around it, whatever its shape. */
  static draw(pen, picture, x, y, side) {
    pen.fillStyle = "#fff";
    pen.beginPath();
    pen.roundRect(x - side / 2, y - side / 2, side, side, side * 0.14);
    pen.fill();
    const room = side * 0.9;
    const scale = room / Math.max(picture.naturalWidth, picture.naturalHeight);
    const width = picture.naturalWidth * scale, height = picture.naturalHeight * scale;
    pen.drawImage(picture, x - width / 2, y - height / 2, width, height);
  }
}
