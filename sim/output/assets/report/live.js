// Follows what a served page shows: asks for news, shows mistakes over the last good report, and loads the next one.

(() => {
  "use strict";
  const shown = Number(document.getElementById("live").dataset.page);
  const KEPT = "linkwright-kept";

  /** An element with text in it, which stays text. */
  function part(tag, name, ...children) {
    const made = document.createElement(tag);
    made.className = name;
    made.append(...children);
    return made;
  }

  /** A mistake as a compiler shows it: where, the line with the words marked, what would be right. */
  function mistake({ code, message, place, line }) {
    const made = part("div", "mistake", part("strong", "", `${code}: ${message}`));
    if (place) made.append(part("p", "place", place));
    if (line) made.append(part("pre", "", line.before, part("mark", "", line.words), line.after));
    return made;
  }

  /** Shows what is wrong, above everything; nothing if nothing is. */
  function tell(notice) {
    document.getElementById("news")?.remove();
    document.documentElement.classList.toggle("mistaken", notice !== null);
    if (notice === null) return;
    const news = part("section", "failure", part("strong", "", notice.title), ...notice.mistakes.map(mistake));
    news.id = "news";
    news.setAttribute("role", "alert");
    document.body.prepend(news);
  }

  /** Loads the page anew, where it was. */
  function reload() {
    if (window.report) {
      sessionStorage.setItem(KEPT, JSON.stringify(window.report.state()));
      // Frames of this page would only delay the next.
      window.report.player.pause();
    }
    location.reload();
  }

  async function follow() {
    let after = 0;
    for (;;) {
      try {
        const answer = await fetch(`/news?after=${after}`);
        if (!answer.ok) return tell({ title: "sim watch was started again: open the address that it printed.", mistakes: [] });
        const news = await answer.json();
        if (news.page !== shown) return reload();
        if (news.number !== after) tell(news.notice);
        after = news.number;
      } catch {
        tell({ title: "sim watch has ended: what is shown no longer follows the file.", mistakes: [] });
        await new Promise((done) => setTimeout(done, 500));
        after = 0;
      }
    }
  }

  const kept = sessionStorage.getItem(KEPT);
  if (kept && window.report) {
    sessionStorage.removeItem(KEPT);
    try {
      window.report.restore(JSON.parse(kept));
    } catch (why) {
      // What an older page kept is no reason to follow no longer.
      console.info(`the view of before is not restored: ${why}`);
    }
  }
  document.documentElement.dataset.page = shown;
  follow();
})();
