// Work that waits until an element can be seen.

/// Does the work once: when `watch(begin)` says so, or before the page is printed. `watch` returns
/// the observer to end then.
function once(work, watch) {
  const begin = () => {
    removeEventListener("beforeprint", begin);
    observer.disconnect();
    work();
  };
  const observer = watch(begin);
  addEventListener("beforeprint", begin);
}

/// Does the work when the element has a width: when it is in the page and not folded away.
export const whenShown = (element, work) =>
  once(work, (begin) => {
    const observer = new ResizeObserver(() => element.clientWidth && begin());
    observer.observe(element);
    return observer;
  });

/// Does the work when the element comes within `margin` of the window.
export const whenNear = (element, margin, work) =>
  once(work, (begin) => {
    const observer = new IntersectionObserver(
      (seen) => seen.some(({ isIntersecting }) => isIntersecting) && begin(),
      { rootMargin: margin },
    );
    observer.observe(element);
    return observer;
  });
