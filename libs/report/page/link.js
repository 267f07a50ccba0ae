// The chosen moment in the page's address: report.html#update=120 opens there.

class MomentLink {
  constructor(count) {
    this.last = count - 1;
    this.anchor = document.getElementById("link");
  }

  /** The update that the address names; the end of the run where it names none. */
  named() {
    const found = /^#update=(\d+)$/.exec(window.location.hash);
    return found ? Math.min(Number(found[1]), this.last) : this.last;
  }

  /** Goes where the address points, now and whenever it changes. */
  follow(goTo) {
    goTo(this.named());
    window.addEventListener("hashchange", () => {
      if (this.named() !== this.step) goTo(this.named());
    });
  }

  /** The address follows the moment, but not while time goes by: browsers allow few changes a second. */
  show(step, playing) {
    this.step = step;
    const hash = `#update=${step}`;
    this.anchor.href = this.anchor.textContent = hash;
    clearTimeout(this.soon);
    if (!playing) this.soon = setTimeout(() => window.history.replaceState(null, "", hash), 200);
  }
}
