// What the drawings of a page answer to pointer and keys: values at a cursor, an enlarged part, a drawing as SVG or CSV. Without this
// script the page is complete.
// Places are shares of an axis, 0 to 1, from left to right and from below. Panels of a run with the same x axis are a group, with its
// track: they have one cursor, and show the same part. Another panel with dots is a map of its own, with a cursor in two directions.
// Where dots or bars have titles, the cursor goes from one to the next, and its values are the title.
{
const { ceil, floor, hypot, log10, max, min, round } = Math;
const all = (parent, what) => [...parent.querySelectorAll(what)], first = (parent, what) => parent.querySelector(what),
  remove = (parent, what) => all(parent, what).forEach(old => old.remove()),
  set = (element, pairs) => Object.entries(pairs).forEach(pair => element.setAttribute(...pair));
const add = (parent, name, pairs, text = '') => {
  const made = parent.appendChild(document.createElementNS(parent.namespaceURI, name));
  set(made, pairs);
  made.append(text);
  return made;
};
const clamp = (low, x, high) => max(low, min(x, high)),
  range = list => [min(...list), max(...list)],
  middle = ends => (ends[0] + ends[1]) / 2, length = ends => ends[1] - ends[0];

// An axis from a position on: positions are values, their logarithms with a sign, or numbers of names.
const axis = words => {
  const [low, span, sign, ...names] = words.split(' '), isLog = +sign, isNamed = sign === 'names',
    value = at => isLog ? 10 ** (sign * at) : at;
  return {
    unit: names.join(' '), isNamed,
    // The value at a place. A linear axis is drawn to four digits of its range.
    text(place, digits = 4) {
      const at = +low + place * span, places = clamp(0, digits - ceil(log10(span)), 20);
      return isNamed ? names[round(at)] : isLog ? +value(at).toPrecision(digits) : (+at.toFixed(places)).toFixed(places);
    },
    // Places and texts of about `count` ticks in a part.
    ticks(part, count) {
      const [from, to] = part.map(place => +low + place * span), rough = (to - from) / count, decade = 10 ** floor(log10(rough));
      const step = isLog || isNamed ? 1 : decade * [1, 2, 5, 10].find(m => m * decade >= rough), found = [];
      for (let k = floor(from / step); k * step <= to; k++) for (const m of isLog && to - from < 2 ? [1, 2, 5] : [1]) {
        const at = k * step + sign * log10(m) || 0;
        if (at >= from && at <= to) found.push([(at - low) / span, isNamed ? names[k] : +value(at).toPrecision(9)]);
      }
      return found;
    }
  };
};
// Lowest and highest value of lines where `over` is within `ends`, or at its only end; none: low > high.
const extent = (lines, over, of, ends) => range(lines.flatMap(line => line[of].flatMap((value, k) => {
  const b = line[over][k], a = line[over][k - 1] ?? b, before = line[of][k - 1],
    cuts = ends.filter(end => (a - end) * (b - end) <= 0).map(end => a === b ? value : before + (end - a) / (b - a) * (value - before));
  return b > ends[0] && b < ends[1] ? [value, ...cuts] : cuts;
})));

first(document, '.help').hidden = false;
const groups = {}, said = add(document.body, 'p', { class: 'said', 'aria-live': 'polite' });
all(document, '.panel').forEach((g, number) => {
  const [left, top, width, height] = g.dataset.box.split(' ').map(Number), begin = [left, top + height], size = [width, -height],
    x = axis(g.dataset.x), y = axis(g.dataset.y), time = g.dataset.t, isMap = first(g, 'circle'),
    isList = first(g, 'title'), isLone = isList || isMap && !time,
    svg = g.parentNode, figure = g.closest('figure'), caption = first(g, '.caption'), title = caption.textContent,
    run = g.closest('[data-run]')?.dataset.run || '', group = groups[isLone ? number : run + (time || g.dataset.x)] ||= { panels: [] };
  let read, part, drag, mark;

  // The lines and the dots: places right, up, and of a track in time.
  const lines = () => read ||= all(g, '.inner :is(path, circle)').map(one => {
    const line = [[], [], []], sums = [0, 0], add = (sum, k, unit) => line[k].push(k % 2 + sum / unit);
    line.name = one.getAttribute('class');
    line.title = first(one, 'title')?.textContent;
    line.data = one.dataset;
    if (one.matches('circle')) ['cx', 'cy'].map((name, k) => add(parseFloat(one.getAttribute(name)), k, k ? -100 : 100));
    else if (one.matches('[d*=l]')) one.getAttribute('d').match(/-?\d+/g).forEach((step, k) => add(sums[k % 2] += +step, k % 2, size[k % 2] * 10));
    one.dataset.t?.split(' ').reduce((sum, step) => (add(sum += +step, 2, 1e5), sum), 0);
    if (line.title) [0, 1].map(k => line[k].splice(0, line[k].length - 1)), line[2] = [line];
    return line;
  });
  const pixel = at => at.map((at, k) => begin[k] + size[k] * clamp(0, (at - part[k][0]) / length(part[k]), 1));
  const show = at => {
    remove(g, '.cursor');
    const cursor = add(g, 'g', { class: 'cursor' }), readout = add(caption, 'tspan', { class: 'cursor' });
    const write = (name, words) => {
      add(readout, 'tspan', { class: name }, name && ' ▪');
      readout.append(' ' + words);
    };
    const point = (name, at, words = x.text(at[0]) + ', ' + y.text(at[1])) => {
      const [cx, cy] = pixel(at);
      add(cursor, 'circle', { cx, cy, r: 45 });
      write(name, words);
    };
    if (isList) point((mark = at).name, [at[0][0], at[1][0]], at.title);
    else if (isLone) point('', at);
    else if (time) for (const line of lines()) {
      const here = [0, 1].map(k => extent([line], 2, k, [at])[0]);
      if (isFinite(here[0])) point(line.name, here);
    } else if (at >= part[0][0] && at <= part[0][1]) {
      add(cursor, 'path', { d: `M${pixel([at])} ${top}v${height}` });
      if (first(svg, '.caption') === caption) write('', x.text(at) + ' ' + x.unit);
      for (const name of new Set(lines().map(line => line.name))) {
        const ends = extent(lines().filter(line => line.name === name), 0, 1, [at]);
        if (ends[0] <= ends[1]) write(name, [...new Set(ends.map(end => y.text(end)))].join(' to '));
      }
    }
  };
  const draw = (...wanted) => {
    part = wanted;
    const [wide, high] = part.map(length), isPart = wide < 1;
    if (isLone) group.part = part[0];
    set(first(g, '.moved'), { x: -100 * part[0][0] / wide + '%', width: 100 / wide + '%', y: 100 * (part[1][1] - 1) / high + '%', height: 100 / high + '%' });
    remove(g, '.now, .cursor');
    g.classList.toggle('part', isPart);
    if (!isPart) return;
    const now = add(g, 'g', { class: 'now' });
    g.prepend(now);
    [x, y].forEach((axis, k) => axis.ticks(part[k], k ? height / 300 + 1 : 6).forEach(([place, words]) => {
      const at = pixel([place, place])[k];
      add(now, 'path', { class: 'grid', d: k ? `M${left} ${at}h${width}` : `M${at} ${top}v${height}` });
      add(add(now, 'g', { class: k ? 'y-ticks' : 'x-ticks' }), 'text', k ? { x: left - 70, y: at, dy: '.35em' } : { x: at, y: top + height + 60, dy: '.8em' }, words);
    }));
  };
  // A part of a map around places, with the ratio of the scales of its axes.
  const around = ends => {
    const half = clamp(5e-4, max(...ends.map(length)) / 2, .5);
    draw(...ends.map(two => clamp(half, middle(two), 1 - half)).map(at => [at - half, at + half]));
  };
  // Shows what the panel has of a part of its group.
  const fit = ends => {
    if (length(ends) === 1) draw(ends, ends);
    else if (time) {
      const found = [0, 1].map(k => extent(lines(), 2, k, ends));
      isFinite(found[0][0]) ? around(found) : draw([0, 1], [0, 1]);
    }
    else if (isMap) around([ends, part[1].fill(middle(part[1]))]);
    else {
      const [low, high] = extent(lines(), 0, 1, ends), margin = .05 * (high - low) || .01;
      draw(ends, y.isNamed || low > high ? [0, 1] : [low - margin, high + margin]);
    }
  };
  const look = at => {
    group.at = +(at[0] ?? at);
    group.panels.forEach(panel => panel.show(at));
  };
  const zoom = (from, to) => {
    if (to - from > 1e-4) group.part = [max(from, 0), min(to, 1)];
    group.panels.forEach(panel => panel.fit(group.part));
  };
  group.panels.push({ show, fit });
  fit(group.part = [0, 1]);

  const hit = add(g, 'rect', { class: 'hit', x: left, y: top, width, height, tabindex: -!!g.previousElementSibling, role: 'application', 'aria-label': title });
  const place = e => {
    const box = hit.getBoundingClientRect();
    return [(e.clientX - box.left) / box.width, (box.bottom - e.clientY) / box.height].map((share, k) => part[k][0] + clamp(0, share, 1) * length(part[k]));
  };
  hit.onpointerdown = e => {
    drag = place(e);
    hit.setPointerCapture(e.pointerId);
  };
  hit.onpointermove = e => {
    const at = place(e);
    // The nearest dot or bar, or of a track the time of its nearest point.
    look(time || isList ? lines().flatMap(line => line[2].map((found, k) => [hypot(!y.isNamed && line[0][k] - at[0], line[1][k] - at[1]), found])).sort((a, b) => a[0] - b[0])[0][1] : isMap ? at : at[0]);
    if (!drag) return;
    const [[from, to], [above, below]] = [0, 1].map(k => range([pixel(drag)[k], pixel(at)[k]]));
    add(first(g, 'g.cursor'), 'rect', { x: from, width: to - from, y: isMap ? above : top, height: isMap ? below - above : height });
  };
  hit.onpointerup = e => {
    const ends = place(e).map((at, k) => range([drag[k], at]));
    drag = 0;
    if (length(ends[0]) > .01 * length(part[0])) isMap ? around(ends) : zoom(...ends[0]);
  };
  hit.onpointercancel = hit.onpointerleave = () => drag = remove(document, '.cursor');
  hit.ondblclick = () => zoom(0, 1);
  hit.onkeydown = e => {
    const here = group.at ?? middle(group.part), wide = length(group.part);
    const step = { ArrowLeft: -.01, ArrowRight: .01 }[e.key] * (e.shiftKey ? 10 : 1), factor = { '+': .25, '-': 1 }[e.key];
    const at = clamp(group.part[0], here + step * wide, group.part[1]);
    const marks = lines().filter(line => line.title);
    if (step) look(isList ? marks[clamp(0, marks.indexOf(mark) + 100 * step, marks.length - 1)] : isLone ? [at, middle(part[1])] : at);
    else if (factor) zoom(here - factor * wide, here + factor * wide);
    else if (e.key === 'Escape') zoom(0, 1);
    else return;
    e.preventDefault();
    said.textContent = caption.textContent;
  };

  // The data of all panels of the drawing, and the drawing with its legend.
  const legend = all(figure, '.legend li').map(li => [first(li, 'svg'), li.textContent, first(li, 'svg *').getAttribute('class')]);
  svg.rows = (svg.rows || []).concat(() => lines().flatMap(line => line[0].map((at, k) =>
    [title, line.title || legend.find(entry => entry[2] === line.name)?.[1], time ? axis(time).text(line[2][k], 6) : '', line.data.x || x.text(at, 6), line.data.y || y.text(line[1][k], 6)].map(JSON.stringify))));
  if (svg.rows.length > 1) return;
  const picture = () => {
    const sheet = svg.cloneNode(true), [,, wide, high] = sheet.getAttribute('viewBox').split(' '), head = 200 * legend.length + 100;
    remove(sheet, '.hit, .cursor');
    set(sheet, { viewBox: [0, -head, wide, +high + head], width: wide / 10, height: (+high + head) / 10 });
    add(sheet, 'style', {}, first(document, 'style').textContent);
    sheet.prepend(add(sheet, 'rect', { class: 'paper', y: -head, width: wide, height: +high + head }));
    legend.forEach(([swatch, words], k) => {
      set(sheet.appendChild(swatch.cloneNode(true)), { x: left, y: 200 * k + 60 - head, width: 340, height: 140 });
      add(sheet, 'text', { x: left + 400, y: 200 * k + 180 - head }, words);
    });
    return new XMLSerializer().serializeToString(sheet);
  };
  const save = add(figure, 'p', { class: 'save' }, 'Save ' + title);
  for (const [kind, type, content] of [['svg', 'image/svg+xml', picture], ['csv', 'text/csv', () => ['panel,line,time,x,y', ...svg.rows.flatMap(rows => rows())].join('\n')]]) add(save, 'button', {}, kind).onclick = () =>
    add(save, 'a', { download: `${run} ${title}.${kind}`, href: URL.createObjectURL(new Blob([content()], { type })) }).click();
});
}
