// Titles of sections put into groups. Without the browser.

const SPLIT = ": ";

const start = (title) => (title.includes(SPLIT) ? title.slice(0, title.indexOf(SPLIT)) : null);
const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/// Titles that follow each other and begin alike, up to a colon, as one entry { title, entries };
/// all others as { title, index }, with their place in the list.
export function groupedTitles(titles) {
  const found = [];
  titles.forEach((title, index) => {
    const name = start(title);
    const last = found.at(-1);
    if (name !== null && last?.name === name)
      last.entries.push({ title: capital(title.slice(name.length + SPLIT.length)), index });
    else
      found.push({
        name,
        entries: [{ title: capital(title.slice((name?.length ?? -2) + SPLIT.length)), index }],
      });
  });
  return found.map(({ name, entries }) =>
    entries.length > 1
      ? { title: name, entries }
      : { title: titles[entries[0].index], index: entries[0].index },
  );
}
