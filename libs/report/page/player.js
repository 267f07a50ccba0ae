// Which moment is shown: slider, buttons, keys, and time going by.

class Player {
  constructor(count, changed) {
    Object.assign(this, { count, changed, step: -1, playing: false });
    const get = (id) => document.getElementById(id);
    this.slider = get("slider");
    this.button = get("play");
    this.pace = get("pace");
    this.slider.max = String(count - 1);
    this.slider.addEventListener("input", () => this.goTo(Number(this.slider.value)));
    this.button.addEventListener("click", () => this.toggle());
    get("previous").addEventListener("click", () => this.goTo(this.step - 1));
    get("next").addEventListener("click", () => this.goTo(this.step + 1));
    document.addEventListener("keydown", (e) => this.key(e));
  }

  /** Shows a step and stops playing. */
  goTo(step) {
    this.stop();
    this.show(step);
  }

  show(step) {
    const next = Math.min(Math.max(Math.round(step), 0), this.count - 1);
    if (next === this.step) return;
    this.step = next;
    this.slider.value = String(next);
    this.changed(next);
  }

  toggle() {
    if (this.playing) return this.stop();
    this.playing = true;
    this.tellButton();
    let at = this.step >= this.count - 1 ? 0 : this.step;
    let before = null;
    const tick = (now) => {
      if (!this.playing) return;
      if (before !== null) at += (((now - before) / 1000) * this.count) / Number(this.pace.value);
      before = now;
      this.show(Math.floor(at));
      if (at >= this.count - 1) this.stop();
      else requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  stop() {
    if (!this.playing) return;
    this.playing = false;
    this.tellButton();
    this.changed(this.step);
  }

  tellButton() {
    this.button.textContent = this.playing ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", this.playing ? "Pause" : "Play");
  }

  /** Keys work wherever the focus is, but for controls that take them themselves. */
  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const tag = event.target.tagName;
    if (tag === "SELECT") return;
    if (event.key === " " && tag !== "BODY" && event.target !== this.slider) return;
    const actions = {
      ArrowLeft: () => this.goTo(this.step - 1),
      ArrowRight: () => this.goTo(this.step + 1),
      Home: () => this.goTo(0),
      End: () => this.goTo(this.count - 1),
      PageUp: () => this.goTo(this.step - 20),
      PageDown: () => this.goTo(this.step + 20),
      " ": () => this.toggle(),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  }
}
