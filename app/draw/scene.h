/* What is to be seen, as data: a list of plain primitives in metres, in painting order, and the words around them. A
 * laboratory makes it from an observation, a painter consumes it, a test reads it. It knows no file, no window and no
 * pixel: widths of lines and sizes of letters are in design points, 1 = a pixel at 1280 x 720, and grow with the
 * picture.
 *
 * A still picture is one scene. A moving one has layers, painted one over the other in the first one's view: what
 * stays, what comes and stays (loci), and what moves. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"
#include "base/vec2.h"
#include "draw/view.h"

/* What a thing is decides how it looks: see palette.h. */
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
    ROLE_COUNT,
} Role;

typedef enum LineStyle { LINE_SOLID, LINE_DASHED, LINE_DOTTED, LINE_DASH_DOT, LINE_STYLES } LineStyle;

typedef enum PrimitiveKind {
    PRIMITIVE_POLYGON,   /* closed rings; with a height, a prism */
    PRIMITIVE_LINE,      /* from point to point; with a height, an upright sheet */
    PRIMITIVE_DISC,      /* of `radius` round each point; with a height, an upright cylinder */
    PRIMITIVE_WHEEL,     /* an upright disc of `radius` on an axle from points[0] to points[1], at `base` */
    PRIMITIVE_BALL,      /* of `radius` round each point, its middle at `base` */
    PRIMITIVE_TICK,      /* a short line through points[0], across the direction to points[1] */
    PRIMITIVE_DIMENSION, /* arrow heads at points[0] and points[1]; from outside where there is no room between */
    PRIMITIVE_LABEL,     /* words near points[0]: the painter looks for a place where they hide nothing */
} PrimitiveKind;

/* Words on a tag or a disc take the ink that is best read on its fill. */
typedef enum LabelShape { LABEL_BARE, LABEL_TAG, LABEL_DISC } LabelShape;

typedef struct Primitive {
    PrimitiveKind kind;
    Role fill;           /* of the inside, of a tag or disc, of the rim around bare words */
    Role edge;           /* of lines and bare words */
    double fill_opacity; /* 0 to 1; 0: not filled */
    double edge_opacity; /* 0 to 1 */
    double width;        /* design points, of the edge; 0: none */
    double base, height; /* m: from where it rises, and how far; seen in the raised view only */
    double radius;       /* m, of discs, wheels and balls */
    LineStyle style;     /* of the edge */
    double begun;        /* m, of a line that another one goes on from: its dashes go on, too */
    bool hatched;        /* polygons: thin lines in `edge` over the fill */
    bool united;         /* polygons: overlapping rings unite; otherwise even-odd, a ring within a ring is a hole */
    const Vec2 *points; /* (count) m; behind a label's first point, if any, the outline of what it names and stays in */
    size_t count;
    const size_t *starts; /* (ring_count + 1) of a polygon's rings in `points` */
    size_t ring_count;
    double size;       /* design points: a label's letters, a tick's length */
    double keep_clear; /* 1, how much labels avoid to cover it; 0: they may */
    LabelShape shape;
    bool bold;
    bool fixed; /* labels: exactly on their point, or beside it towards points[1], whatever they hide: what moves must
                   not jump */
    bool optional; /* labels: better left out than put over something */
    bool close;    /* labels: left out where there is no room within the outline, or right beside the point */
    bool leader;   /* labels: a thin line to points[0] when they have to move away */
    const char *text;
} Primitive;

/* A sign in the middle of a row's piece of line, of the row's role: told apart by their shapes. */
typedef enum Symbol { SYMBOL_NONE, SYMBOL_DISC, SYMBOL_BOX, SYMBOL_DIAMOND, SYMBOL_TRIANGLE, SYMBOLS } Symbol;

/* One row of the list beside the picture. */
typedef enum RowKind {
    ROW_HEADING, /* begins a section */
    ROW_DISC,    /* begins with a disc of `role`, `mark` on it */
    ROW_LINE,    /* begins with a piece of line of `role`, `style` and `width`, `mark` on it */
    ROW_PLAIN,
} RowKind;

enum { ROW_CELLS = 3 };

typedef struct SceneRow {
    RowKind kind;
    Role role;
    LineStyle style;
    double width; /* design points; 0: only the symbol */
    Symbol symbol;
    const char *mark; /* or NULL */
    const char
        *cells[ROW_CELLS]; /* or NULL; the first to the left and shortened where needed, the others to the right */
} SceneRow;

enum { SCENE_PANELS = 6 };

/* Zero is an empty scene; scene_clear releases it. */
typedef struct Scene {
    Primitive *primitives; /* (count) in painting order; among labels the earlier choose their places first */
    size_t count, capacity;
    SceneRow *rows; /* (row_count) */
    size_t row_count, row_capacity;
    Box box;             /* m, what must be seen */
    double top;          /* m, up to what height, in the raised view */
    Camera camera;       /* from where; zero: the plan */
    bool bare;           /* nothing round it but the scale: a detail of another picture */
    bool unscaled;       /* no scale bar: it says how large it is */
    int panels;          /* pictures beside it, for instance plots, in place of the rows; at most SCENE_PANELS */
    double panel_height; /* design points, at least, of panels that stand below it; 0: where they leave it larger */
    double grid;         /* m, between the faint lines; 0: none */
    const char *title;   /* the answer: the eye finds it first */
    Role title_role;     /* ROLE_TEXT, or ROLE_ERROR when the answer is no */
    const char *detail;  /* one line more about it */
    const char *name;    /* of what is shown; texts that are NULL are not there */
    const char *note;    /* what must be said wherever it is shown, or "" */
    const char *clock;   /* the time, or the span of time, that is shown */
    Arena arena;         /* holds points and texts */
} Scene;

void scene_clear(Scene *scene);

/* Empties a scene but keeps what memory it has: for layers that are made anew for every frame. */
void scene_reset(Scene *scene);

/* Each adds a copy of what it is given and returns the addition, to be adorned; good until the next one. */
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

/* Adds a copy of all that another one shows. */
void scene_add_all(Scene *scene, const Scene *other);

/* Gives a label the outline of what it names. */
void scene_bind_label(Scene *scene, Primitive *label, const Vec2 *outline, size_t count);

/* A text made as by printf, as long as the scene lives. */
const char *scene_text(Scene *scene, const char *format, ...) __attribute__((format(printf, 2, 3), nonnull));
