/* A picture as data: a list of plain primitives in metres, in painting order, and the texts around them. A laboratory
 * makes a scene from an observation, a painter draws it, a test reads it. A scene knows no file, no window and no
 * pixel: line widths and text sizes are in design points, 1 = a pixel at 1280 x 720, and grow with the picture.
 *
 * A still picture is one scene. A moving one has layers, painted over each other in the view of the first: the fixed
 * part, the growing part (loci) and the moving part. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"
#include "base/vec2.h"
#include "draw/view.h"

/* The role of an object decides its look: see palette.h. */
typedef enum Role {
    ROLE_PAPER,
    ROLE_PANEL,
    ROLE_GRID,
    ROLE_ROOM,
    ROLE_WALL,
    ROLE_FURNITURE,
    ROLE_FURNITURE_LINE,
    ROLE_DOOR,
    ROLE_CHAIR,
    ROLE_RING,
    ROLE_LOCUS,
    ROLE_LOCUS_SECOND,
    ROLE_LOCUS_THIRD,
    ROLE_LOCUS_FOURTH,
    ROLE_GHOST,
    ROLE_WALKER,
    ROLE_DANGER_LOW,
    ROLE_DANGER_MIDDLE,
    ROLE_DANGER_HIGH,
    ROLE_EXIT,
    ROLE_EXIT_TAG,
    ROLE_TEXT,
    ROLE_DIM_TEXT,
    ROLE_ERROR,
    ROLE_IMPACT,
    ROLE_SHADE,
    ROLE_BAND, /* within a ROLE_GRID area, under ROLE_LOCUS: lighter or darker than both, also without colour */
    ROLE_CLASS_NONE,
    ROLE_CLASS_FIRST,
    ROLE_CLASS_SECOND,
    ROLE_CLASS_THIRD,
    ROLE_CLASS_FOURTH,
    ROLE_CLASS_FIFTH,
    ROLE_CLASS_SIXTH,
    ROLE_TYPE_FIRST,
    ROLE_TYPE_SECOND,
    ROLE_TYPE_THIRD,
    ROLE_DENSITY_FIRST,
    ROLE_DENSITY_SECOND,
    ROLE_DENSITY_THIRD,
    ROLE_DENSITY_FOURTH,
    ROLE_DENSITY_FIFTH,
    ROLE_COUNT,
} Role;

typedef enum LineStyle { LINE_SOLID, LINE_DASHED, LINE_DOTTED, LINE_DASH_DOT, LINE_STYLES } LineStyle;

typedef enum PrimitiveKind {
    PRIMITIVE_POLYGON,   /* closed rings; with a height, a prism */
    PRIMITIVE_LINE,      /* from point to point; with a height, an upright sheet */
    PRIMITIVE_DISC,      /* of `radius` round each point; with a height, an upright cylinder */
    PRIMITIVE_WHEEL,     /* an upright disc of `radius` on an axle from points[0] to points[1], at `base` */
    PRIMITIVE_BALL,      /* of `radius` round each point, centred at `base` */
    PRIMITIVE_TICK,      /* a short line through points[0], across the direction to points[1] */
    PRIMITIVE_DIMENSION, /* arrow heads at points[0] and points[1], from outside where they have no room between */
    PRIMITIVE_LABEL,     /* a text near points[0]: the painter looks for a place where it hides nothing */
} PrimitiveKind;

/* Text on a tag or a disc is black or white, whichever is more legible on the fill. */
typedef enum LabelShape { LABEL_BARE, LABEL_TAG, LABEL_DISC } LabelShape;

typedef struct Primitive {
    PrimitiveKind kind;
    Role fill;           /* of the inside, of a tag or disc, of the rim around bare text */
    Role edge;           /* of lines and bare text */
    double fill_opacity; /* 0 to 1; 0: not filled */
    double edge_opacity; /* 0 to 1 */
    double width;        /* design points, of the edge; 0: none */
    double base, height; /* m: the lower end and the extent upwards; visible in the raised view only */
    double radius;       /* m, of discs, wheels and balls */
    LineStyle style;     /* of the edge */
    double begun;        /* m, length of the line that this one continues: its dashes continue, too */
    bool hatched;        /* polygons: thin lines in `edge` over the fill */
    bool united;         /* polygons: overlapping rings unite; otherwise even-odd: a ring within a ring is a hole */
    bool joined;        /* polygons: others join on along the edges, so that the fill may end there without smoothing */
    const Vec2 *points; /* (count) m; behind a label's first point, if any, the outline that it names and stays in */
    size_t count;
    const size_t *starts; /* (ring_count + 1) of a polygon's rings in `points` */
    size_t ring_count;
    double size;       /* design points: a label's text size, a tick's length */
    double keep_clear; /* 1, weight against being covered by labels; 0: may be covered */
    LabelShape shape;
    bool bold;
    bool fixed;    /* labels: exactly on their point, or next to it towards points[1]: moving labels must not jump.
                      With more points, next to points[1] towards points[2], or next to points[3] towards points[4],
                      and so on: the first place that is free, otherwise the nearest free one around points[0] */
    bool optional; /* labels: left out rather than put over something */
    bool note;     /* labels: says how the picture is made; left out of a quiet scene */
    bool level;    /* labels: never turned */
    bool close;    /* labels: left out where there is no room within the outline, or right next to the point */
    Box apart;     /* labels with several places, m: the label lies inside or outside, not across the edge; empty: no
                      matter */
    const char *brief; /* labels: a shorter text for where the text has no room; such a label is never left out */
    bool leader;       /* labels: a thin line to points[0] when they have to move away */
    double widest;     /* labels exactly on their point, m: where they are wider their letters are smaller, down to
                          LABEL_SMALLEST of their size; 0: any width */
    const char *text;
} Primitive;

/* A symbol in the middle of a row's line sample, in the row's role; symbols differ by shape. */
typedef enum Symbol { SYMBOL_NONE, SYMBOL_DISC, SYMBOL_BOX, SYMBOL_DIAMOND, SYMBOL_TRIANGLE, SYMBOLS } Symbol;

/* A row of the list next to the picture. */
typedef enum RowKind {
    ROW_HEADING, /* begins a section */
    ROW_DISC,    /* begins with a disc of `role`, `mark` on it */
    ROW_LINE,    /* begins with a line sample of `role`, `style` and `width`, `mark` on it */
    ROW_PLAIN,
} RowKind;

enum { ROW_CELLS = 3 };

typedef struct SceneRow {
    RowKind kind;
    Role role;
    LineStyle style;
    double width; /* design points; 0: only the symbol */
    Symbol symbol;
    const char *mark;             /* or NULL */
    const char *cells[ROW_CELLS]; /* or NULL; the first aligned left, shortened if needed, the others right */
} SceneRow;

enum { SCENE_PANELS = 6 };

/* Zero is an empty scene; scene_clear releases it. */
typedef struct Scene {
    Primitive *primitives; /* (count) in painting order; earlier labels choose their places first */
    size_t count, capacity;
    SceneRow *rows; /* (row_count) */
    size_t row_count, row_capacity;
    Box box;             /* m, the part that must be visible */
    double top;          /* m, the height up to which the raised view must show */
    Camera camera;       /* the viewpoint; zero: the plan */
    bool bare;           /* only the scale around it: a detail of another picture */
    bool unscaled;       /* without a scale bar: the picture states its own size */
    bool quiet;          /* without notes: for a presentation */
    bool keyed;          /* with a key at the foot, which the scale bar keeps off: */
    double key_end;      /* m, its right end */
    Box taken;           /* design points of the page: labels stay out of it, since a button lies there; empty: none */
    int panels;          /* pictures next to it, for instance plots, instead of the rows; at most SCENE_PANELS */
    double panel_height; /* design points, the least height of panels below the plan; 0: the place that leaves the plan
                            larger */
    double grid;         /* m, between the faint lines; 0: none */
    const char *title;   /* the answer, in the largest text */
    Role title_role;     /* ROLE_TEXT, or ROLE_ERROR for a negative answer */
    const char *detail;  /* one more line about the answer */
    const char *name;    /* of the displayed object; NULL texts are left out */
    const char *note;    /* a caveat that every picture must show, or "" */
    const char *clock;   /* the displayed time or span of time */
    Arena arena;         /* holds points and texts */
} Scene;

void scene_clear(Scene *scene);

/* Empties a scene but keeps its memory: for layers that are remade for every frame. */
void scene_reset(Scene *scene);

/* Each adds a copy of its arguments and returns the new primitive, to be adjusted; the pointer is valid until the next
 * addition. */
Primitive *scene_add_polygon(Scene *scene, Role fill, const Vec2 *points, size_t count);
Primitive *scene_add_rings(Scene *scene, Role fill, const Vec2 *points, const size_t *starts, size_t ring_count);
Primitive *scene_add_line(Scene *scene, Role edge, double width, const Vec2 *points, size_t count);
Primitive *scene_add_discs(Scene *scene, Role fill, double radius, const Vec2 *centres, size_t count);
Primitive *scene_add_wheel(Scene *scene, Role fill, double radius, Vec2 from, Vec2 to);
Primitive *scene_add_ball(Scene *scene, Role fill, double radius, Vec2 at);
Primitive *scene_add_star(Scene *scene, Role fill, double radius, Vec2 at);
Primitive *scene_add_tick(Scene *scene, Role edge, double width, double size, Vec2 at, Vec2 towards);
Primitive *scene_add_dimension(Scene *scene, Role edge, double width, Vec2 from, Vec2 to);
Primitive *scene_add_label(Scene *scene, Role role, double size, Vec2 at, const char *text);
SceneRow *scene_add_row(Scene *scene, RowKind kind, const char *first);

/* Adds a copy of all primitives of another scene. */
void scene_add_all(Scene *scene, const Scene *other);

/* Gives a label the outline of its object. */
void scene_bind_label(Scene *scene, Primitive *label, const Vec2 *outline, size_t count);

/* Returns a text formatted as by printf; it lives as long as the scene. */
const char *scene_text(Scene *scene, const char *format, ...) __attribute__((format(printf, 2, 3), nonnull));
