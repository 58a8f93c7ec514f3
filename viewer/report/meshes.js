// Meshes stand once in a report, and items name them.

/// The report with the meshes themselves in place of their names; an unknown name stays, for
/// check.js to complain about.
export function withMeshes(report) {
  const meshes = report?.meshes;
  if (!meshes || !Array.isArray(report.sections)) return report;
  const found = (item) =>
    item?.kind === "mesh" && Object.hasOwn(meshes, item.mesh)
      ? { ...item, mesh: meshes[item.mesh] }
      : item;
  const inLayer = (layer) =>
    Array.isArray(layer?.items) ? { ...layer, items: layer.items.map(found) } : layer;
  const inBlock = (block) => {
    if (block?.type === "row" && Array.isArray(block.blocks))
      return { ...block, blocks: block.blocks.map(inBlock) };
    if (block?.type !== "scene" || !Array.isArray(block.layers)) return block;
    return { ...block, layers: block.layers.map(inLayer) };
  };
  const inSection = (section) =>
    Array.isArray(section?.blocks)
      ? { ...section, blocks: section.blocks.map(inBlock) }
      : section;
  return { ...report, sections: report.sections.map(inSection) };
}
