// What one frame shares. "Cells" are lattice units counted from the frame's anchor, the lattice
// point nearest to the eye; view space is in stage units (about half a model), +z to the viewer.
layout(std140) uniform Frame {
  mat4 clipFromCells;
  mat4 viewFromCells;
  mat4 shadowFromCells;
  mat4 worldFromView;  // rotation only
  vec4 viewport;       // width, height of the whole picture, where the background is brightest
  vec4 part;           // of the picture that is drawn: left, bottom, width, height
  vec4 stage;          // cells per stage unit, dither, perspective (0 or 1), turn of taps
  vec4 shadowing;      // tap radius on clay, on the floor, strength, taps
  vec4 floorPlane;     // centre (cells), half side (cells)
  vec4 extra;          // half side of the floor's map (cells), floor in sight (0 or 1),
                       // pixels per stage unit at depth 1
  vec4 taps[16];       // places in a disk of radius 1 where the shadow map is read
};
