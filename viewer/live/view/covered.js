// Parts of the picture that panels cover, in CSS pixels. Independent of the browser.

const TRIAD = 84; // width and height of the corner in which the axes are drawn
const BAR = { width: 110, height: 36 }; // of the scale bar's

/// Boxes { left, right, top, bottom } where no words may stand: below the panels, which leave the picture its
/// `insets`, on the triad and the scale bar between them, and on the `legend` where that is a box.
export function coveredBoxes({ width, height, insets }, legend = null) {
  const [right, bottom] = [width - insets.right, height - insets.bottom];
  return [
    { left: 0, right: insets.left, top: 0, bottom: height },
    { left: right, right: width, top: 0, bottom: height },
    { left: 0, right: width, top: 0, bottom: insets.top },
    { left: 0, right: width, top: bottom, bottom: height },
    { left: insets.left, right: insets.left + TRIAD, top: bottom - TRIAD, bottom },
    { left: right - BAR.width, right, top: bottom - BAR.height, bottom },
    ...(legend ? [legend] : []),
  ];
}
