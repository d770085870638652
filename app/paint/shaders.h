/* The programs of the graphics card, in GLSL 3.30. */
#pragma once

/* Shapes: see ink.h. Uniforms: `canvas`, its size in pixels; `dashes` of each line style, see paint_sizes.h; `light`,
 * towards the light, of balls: x to the right, y down, z out of the page. */
extern const char shaders_ink_vertex[], shaders_ink_fragment[];

/* Plain triangles of one colour: less work per pixel. Uniform: `canvas`. */
extern const char shaders_face_vertex[], shaders_face_fragment[];

/* Texts: rectangles out of the atlas; the colour is the corner's, the opacity the picture's. Uniforms: `canvas` and
 * `atlas`, sizes in pixels. */
extern const char shaders_text_vertex[], shaders_text_fragment[];

/* Triangles over a window: place in pixels, y down; the corner's colour times the picture's. Uniform: `canvas`. */
extern const char shaders_screen_vertex[], shaders_screen_fragment[];
