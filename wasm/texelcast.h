/* Texelcast core: the C ABI, and its manual.
 *
 * The one public header of the core. It is plain C, so that a WebAssembly host can call it without glue, and it is
 * written in the order in which a program calls it:
 *
 *   session -> model -> target (bake) -> base picture -> images -> layers -> fills, strokes' dabs -> update -> read
 *   -> print truth
 *
 * Rules that hold for every call:
 *   - Structs hold 4-byte fields only, so their layout is the same in wasm32 and natively. Fill one with its
 *     `txc_*_default` maker first, then set the fields you mean.
 *   - Handles are ids that are never given out twice; 0 is null. A handle used after its object was destroyed, or of
 *     another session, gives TXC_STATUS_STALE_HANDLE and touches nothing.
 *   - Inputs are copied before the call returns. Outputs that are pointers belong to the session and live until the
 *     call that their comment names.
 *   - A call that fails changes nothing, and `txc_error_detail` then says which field and which value was at fault.
 *   - Nothing here is thread-safe: one session belongs to one thread.
 *   - Same input, same bytes, on every machine (spec section 7).
 *
 * Spaces (spec section 1): model space is metres, right-handed, +Y up. Texture space has its origin at the top left;
 * row 0 is the top row. Decal space is the box [-1/2, 1/2]^3 whose +Z points from the surface to the viewer.
 */
#ifndef TEXELCAST_H
#define TEXELCAST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__EMSCRIPTEN__)
#define TXC_API __attribute__((used, visibility("default")))
#else
#define TXC_API
#endif

#define TXC_ABI_VERSION 9u
#define TXC_MAX_SIZE 8192u          /* texels along one side of a target or an image */
#define TXC_MAX_TEXTURE_SIZE 16384u /* texels along one side of a texture that is painted by windows */
#define TXC_MAX_ZONES 100u
#define TXC_MAX_DABS 1000000u /* of one stroke */
#define TXC_MAX_DEPTH 17u     /* of a layer in a layer in a layer: 1 is in none */
#define TXC_MAX_STOPS 16u     /* of a gradient */

/* ---- Statuses ---------------------------------------------------------------------------------------------------
 * One list; names and messages are read from the module itself (txc_status_name, txc_status_message), so that no
 * other language keeps a copy. The names are stable: hosts may branch on them. */
#define TXC_STATUS_LIST(X)                                                                                             \
    X(OK, "done")                                                                                                      \
    X(PENDING, "there is more work to do: call again")                                                                 \
    X(BAD_ARGUMENT, "an argument is out of its range")                                                                 \
    X(STALE_HANDLE, "the handle is null, was destroyed, or belongs to another session")                                \
    X(OUT_OF_BUDGET, "the work would need more memory than the session's budget allows")                               \
    X(BAD_SIZE, "a width or height is 0 or above 8192")                                                                \
    X(NO_MODEL, "the session has no model yet")                                                                        \
    X(BAD_MODEL, "the model's bytes are not a valid binary glTF 2.0 file")                                             \
    X(UNSUPPORTED_MODEL, "the model needs a glTF extension that the core does not read")                               \
    X(BAD_GEOMETRY, "the model's geometry has values that cannot be used")                                             \
    X(NO_MATERIAL, "the model has no material with that index")                                                        \
    X(NO_TRIANGLES, "there are no triangles to paint")                                                                 \
    X(NO_UVS, "the material's triangles have no texture coordinates, so there is no texture to paint")                 \
    X(BAD_UVS, "the texture coordinates are not finite, too far out of range, or without area")                        \
    X(NOT_BAKED, "the target's bake has not finished")                                                                 \
    X(INTERNAL, "a fault of the core itself: please report it")

typedef enum TxcStatus {
#define TXC_STATUS_ENUM(name, message) TXC_STATUS_##name,
    TXC_STATUS_LIST(TXC_STATUS_ENUM)
#undef TXC_STATUS_ENUM
        TXC_STATUS_COUNT
} TxcStatus;

typedef uint32_t TxcSession;
typedef uint32_t TxcTarget;
typedef uint32_t TxcImage;
typedef uint32_t TxcLayer;

TXC_API uint32_t txc_abi_version(void);
TXC_API uint32_t txc_status_count(void);
/* Static strings, zero-terminated UTF-8, never freed. Unknown statuses give "UNKNOWN". */
TXC_API const char* txc_status_name(uint32_t status);
TXC_API const char* txc_status_message(uint32_t status);
/* What exactly was wrong in the newest call that failed; "" after a call that succeeded. Lives until the next call. */
TXC_API const char* txc_error_detail(void);

/* Scratch memory for a host that must place bytes inside the module before a call. Null where there is none left. */
TXC_API void* txc_alloc(uint32_t byte_count);
TXC_API void txc_free(void* memory);

/* ---- Session ---------------------------------------------------------------------------------------------------- */
typedef struct TxcSessionDef {
    uint32_t memory_budget_mib; /* what the session may hold at once, MiB; default 1024 */
} TxcSessionDef;

typedef struct TxcSessionStats {
    uint32_t bake_count;        /* bakes finished since the session began: proves that a map is reused */
    uint32_t projection_count;  /* layers projected since the session began */
    uint32_t projected_texels;  /* texels that the newest update shaded */
    uint32_t composited_texels; /* texels that the newest update composited */
    uint32_t memory_used_kib;   /* held now, as counted against the budget */
    uint32_t memory_peak_kib;   /* most held at once since the session began */
    uint32_t memory_budget_kib;
} TxcSessionStats;

TXC_API void txc_session_def_default(TxcSessionDef* def);
TXC_API TxcStatus txc_session_create(const TxcSessionDef* def, TxcSession* out_session);
/* Destroys the session and everything in it. */
TXC_API TxcStatus txc_session_destroy(TxcSession session);
TXC_API TxcStatus txc_session_stats(TxcSession session, TxcSessionStats* out_stats);

/* ---- Model ------------------------------------------------------------------------------------------------------
 * A session holds one model. Loading another one destroys the targets, maps and layers of the one before; images stay.
 * A failed load leaves the old model as it was. */
#define TXC_NONE 0xffffffffu

typedef struct TxcModelInfo {
    uint32_t material_count; /* the file's materials, plus one after the last if any primitive names none */
    uint32_t triangle_count;
    uint32_t vertex_count;
    uint32_t has_default_material; /* 1 if the last material is glTF's implied one */
    float bounds_min_model[3];
    float bounds_max_model[3];
} TxcModelInfo;

typedef struct TxcMaterialInfo {
    uint32_t paint_status; /* TXC_STATUS_OK, or why the material cannot take decals */
    uint32_t triangle_count;
    uint32_t degenerate_uv_triangles;   /* without area in texture space: they own no texel */
    uint32_t out_of_range_uv_triangles; /* with a UV outside [0, 1]: they wrap */
    uint32_t tex_coord;                 /* the UV set that the base colour texture names */
    uint32_t image;                     /* the file's image index of the base colour texture, or TXC_NONE */
    uint32_t nearest_filter;            /* 1 if the texture's sampler magnifies with NEAREST (pixel art) */
    float base_color_factor[4];         /* linear, as in the file */
    float uv_min[2];
    float uv_max[2];
    float bounds_min_model[3];
    float bounds_max_model[3];
} TxcMaterialInfo;

/* One mesh as a three.js BufferGeometry has it. */
typedef struct TxcMeshDef {
    uint32_t vertex_count;
    uint32_t index_count; /* 0 without indices: every three vertices are a triangle */
    uint32_t material;    /* any number below 1024; materials count up to the highest used */
} TxcMeshDef;

/* Reads a binary glTF 2.0 file (GLB; also a self-contained .gltf) without Draco or meshopt compression. The scene is
 * gathered at rest (spec section 1). Pictures are not decoded.
 * Errors: BAD_MODEL, UNSUPPORTED_MODEL, BAD_GEOMETRY, NO_TRIANGLES, OUT_OF_BUDGET. */
TXC_API TxcStatus txc_model_load_glb(TxcSession session, const uint8_t* bytes, uint32_t byte_count);
TXC_API void txc_mesh_def_default(TxcMeshDef* def);
/* Adds raw arrays to the session's model (and starts one where there is none): positions 3 floats a vertex in model
 * space, normals 3 floats or null (flat), uvs 2 floats or null, indices or null. Destroys the session's targets. */
TXC_API TxcStatus txc_model_add_mesh(TxcSession session, const TxcMeshDef* def, const float* positions_model,
                                     const float* normals_model, const float* uvs, const uint32_t* indices);
TXC_API TxcStatus txc_model_info(TxcSession session, TxcModelInfo* out_info);
TXC_API TxcStatus txc_material_info(TxcSession session, uint32_t material, TxcMaterialInfo* out_info);
/* Writes the UV triangles of a material: 6 floats (u, v of three corners) for each of its triangles. `capacity` is the
 * number of triangles that fit. BAD_ARGUMENT where it is too small. */
TXC_API TxcStatus txc_material_uvs(TxcSession session, uint32_t material, float* out_uvs, uint32_t capacity);

/* ---- Target and bake --------------------------------------------------------------------------------------------
 * A target is one material's base colour texture at a size of your choice, with its baked local space map and its
 * layers. The map depends on model, material, size and gutter alone: a second target of the same four, or the same
 * target again after being destroyed, reuses it without a bake (TxcSessionStats.bake_count). */
typedef struct TxcTargetDef {
    uint32_t material; /* glTF material index; default 0 */
    uint32_t width;    /* texels, 1 to 8192; default 1024 */
    uint32_t height;
    uint32_t gutter;     /* texels, 0 to 64; default TXC_NONE: 2 at 1024, in proportion, never less than 2 */
    uint32_t mip_levels; /* levels that updates report: 1 (default) is the texture alone, 0 the whole chain */
    /* A target may be a window of a larger texture, of which it has the very texels: but for those less than gutter and bleed
     * (txc_target_read_bled) away from a border that it cuts, as what lies beyond is not known there. (The rim of a stroke's round
     * dab that it cuts may be a step or two away: its tip goes by the texels that the window has.) It has one level. */
    uint32_t texture_width; /* texels, up to TXC_MAX_TEXTURE_SIZE; 0 (default): as width, and the window is the whole */
    uint32_t texture_height;
    uint32_t window_x; /* where in the texture the target begins; multiples of 16 */
    uint32_t window_y;
} TxcTargetDef;

typedef struct TxcMapInfo {
    uint32_t width, height, gutter;
    uint32_t covered_texels;
    uint32_t gutter_texels;
    uint32_t overlapping_texels; /* covered by two triangles or more */
    uint32_t byte_count;         /* the map at rest, all that is derived from it included */
    uint32_t mip_levels;         /* of the target */
    float bounds_min_model[3];   /* of the material's triangles; position views are scaled by it */
    float bounds_max_model[3];
} TxcMapInfo;

TXC_API void txc_target_def_default(TxcTargetDef* def);
/* Errors: NO_MODEL, NO_MATERIAL, NO_TRIANGLES, NO_UVS, BAD_UVS, BAD_SIZE, BAD_ARGUMENT, OUT_OF_BUDGET. */
TXC_API TxcStatus txc_target_create(TxcSession session, const TxcTargetDef* def, TxcTarget* out_target);
/* Bakes on: at least one step, then until about `work_limit` texels were visited. PENDING while there is more; OK when
 * the map is ready (at once, where it is reused). To cancel, destroy the target. `out_progress` (may be null): 0 to 1. */
TXC_API TxcStatus txc_target_bake(TxcSession session, TxcTarget target, uint32_t work_limit, float* out_progress);
TXC_API TxcStatus txc_target_destroy(TxcSession session, TxcTarget target);
TXC_API TxcStatus txc_map_info(TxcSession session, TxcTarget target, TxcMapInfo* out_info);

/* Rows [row, row + row_count) of the map, top down. Empty texels are 0. `positions`: 3 floats a texel, metres, model
 * space. `normals`: 3 floats, unit. `coverage`: 0 empty, 1 covered, 2 gutter. `overlap`: how many triangles cover the
 * texel, capped at 255. NOT_BAKED before the bake has finished. */
TXC_API TxcStatus txc_map_read_positions(TxcSession session, TxcTarget target, uint32_t row, uint32_t row_count,
                                         float* out);
TXC_API TxcStatus txc_map_read_normals(TxcSession session, TxcTarget target, uint32_t row, uint32_t row_count,
                                       float* out);
TXC_API TxcStatus txc_map_read_coverage(TxcSession session, TxcTarget target, uint32_t row, uint32_t row_count,
                                        uint8_t* out);
TXC_API TxcStatus txc_map_read_overlap(TxcSession session, TxcTarget target, uint32_t row, uint32_t row_count,
                                       uint8_t* out);

/* RGBA pictures of the map, as the paper's figure shows them; empty texels are transparent black. Positions: x, y, z of
 * the material's bounding box as red, green, blue. Normals: (n + 1) / 2. Coverage: covered light, gutter darker.
 * Overlap: one triangle green, two amber, more red. */
typedef enum TxcMapView {
    TXC_VIEW_POSITIONS,
    TXC_VIEW_NORMALS,
    TXC_VIEW_COVERAGE,
    TXC_VIEW_OVERLAP,
    TXC_VIEW_COUNT
} TxcMapView;
TXC_API TxcStatus txc_map_view(TxcSession session, TxcTarget target, uint32_t view, uint32_t row, uint32_t row_count,
                               uint8_t* out_rgba);

/* ---- Base picture -----------------------------------------------------------------------------------------------
 * What the layers lie on. A new target's base is the material's base colour factor (as sRGB), or white. */
typedef enum TxcFilter { TXC_FILTER_LINEAR, TXC_FILTER_NEAREST, TXC_FILTER_COUNT } TxcFilter;
/* RGBA, straight alpha, width x height of its own; resampled to the target's size with `filter`. */
TXC_API TxcStatus txc_target_set_base(TxcSession session, TxcTarget target, uint32_t width, uint32_t height,
                                      const uint8_t* rgba, uint32_t filter);
TXC_API TxcStatus txc_target_set_base_color(TxcSession session, TxcTarget target, uint32_t red, uint32_t green,
                                            uint32_t blue, uint32_t alpha);

/* ---- Images (the decals' pictures) ------------------------------------------------------------------------------ */
/* RGBA, sRGB, straight alpha, row 0 at the top. May be used by any layer of the session. */
TXC_API TxcStatus txc_image_create(TxcSession session, uint32_t width, uint32_t height, const uint8_t* rgba,
                                   TxcImage* out_image);
/* Layers that use it turn transparent; give them another image or destroy them. */
TXC_API TxcStatus txc_image_destroy(TxcSession session, TxcImage image);

/* ---- Layers -----------------------------------------------------------------------------------------------------
 * A target's layers are a tree. A layer's content (a group's) and its mask (any layer's) are lists of layers, each bottom to
 * top, as the target's own list is.
 *
 * A group is composited by itself, as W3C's isolated groups are, and what comes out is laid on what is below it by its
 * opacity, blend, blend space and alpha lock. One that is not isolated and blends normally lets its content onto what is
 * below, layer by layer; each texel then goes from how it was before to how it is now as far as opacity and mask say,
 * colours weighted by their alpha, in the group's blend space.
 *
 * A mask is composited onto alpha 1: erasing layers hide, all others show. Its alpha, or 1 less it, multiplies what the
 * masked layer lays on; colour, blend space and the other modes mean nothing in it. An empty mask shows all. */
typedef enum TxcLayerKind {
    TXC_LAYER_DECAL,
    TXC_LAYER_FILL,
    TXC_LAYER_STROKE,
    TXC_LAYER_GROUP,
    TXC_LAYER_KIND_COUNT
} TxcLayerKind;
/* What a layer is to its parent. */
typedef enum TxcRole { TXC_ROLE_CONTENT, TXC_ROLE_MASK, TXC_ROLE_COUNT } TxcRole;
typedef enum TxcProjector {
    TXC_PROJECTOR_PLANAR,      /* a box: position, rotation, size */
    TXC_PROJECTOR_PERSPECTIVE, /* an eye that looks along its own -Z: position, rotation, fov to far_distance */
    TXC_PROJECTOR_CYLINDRICAL, /* rays away from the Y axis: position, rotation, radius to depth */
    TXC_PROJECTOR_UV,          /* a flat stamp in the texture: uv_*; culling, fade and occlusion do not apply to it */
    TXC_PROJECTOR_COUNT
} TxcProjector;
/* The modes of W3C Compositing and Blending Level 1 under their names there, and erase: destination out, which takes the
 * target's alpha away by the layer's and leaves colour alone. */
typedef enum TxcBlend {
    TXC_BLEND_NORMAL,
    TXC_BLEND_MULTIPLY,
    TXC_BLEND_SCREEN,
    TXC_BLEND_OVERLAY,
    TXC_BLEND_DARKEN,
    TXC_BLEND_LIGHTEN,
    TXC_BLEND_COLOR_DODGE,
    TXC_BLEND_COLOR_BURN,
    TXC_BLEND_HARD_LIGHT,
    TXC_BLEND_SOFT_LIGHT,
    TXC_BLEND_DIFFERENCE,
    TXC_BLEND_EXCLUSION,
    TXC_BLEND_HUE,
    TXC_BLEND_SATURATION,
    TXC_BLEND_COLOR,
    TXC_BLEND_LUMINOSITY,
    TXC_BLEND_ERASE,
    TXC_BLEND_COUNT
} TxcBlend;
/* Where colours are mixed: as encoded (CSS, Canvas 2D, image editors), or in linear light. */
typedef enum TxcBlendSpace { TXC_BLEND_SPACE_SRGB, TXC_BLEND_SPACE_LINEAR, TXC_BLEND_SPACE_COUNT } TxcBlendSpace;
typedef enum TxcWrap { TXC_WRAP_NONE, TXC_WRAP_REPEAT, TXC_WRAP_COUNT } TxcWrap;
typedef enum TxcOcclusion { TXC_OCCLUSION_SELF, TXC_OCCLUSION_NONE, TXC_OCCLUSION_COUNT } TxcOcclusion;
/* What a stroke's brush prints with each dab. */
typedef enum TxcTip {
    TXC_TIP_ROUND,   /* a disc of `color` as wide as the dab, softened by `hardness` */
    TXC_TIP_PICTURE, /* `image` as it is */
    TXC_TIP_MASK,    /* the alpha of `image` in `color` */
    TXC_TIP_COUNT
} TxcTip;

/* The defaults are those of spec section 8. Flags are 0 or 1. Of the projectors' fields those of the layer's own kind
 * are checked and count, the others are kept; a stroke's projectors are its dabs'. Their lengths and extents, and `aspect`, are
 * from 1e-12 to 1e12. */
typedef struct TxcLayerDef {
    uint32_t kind;           /* TxcLayerKind */
    uint32_t image;          /* decal, stroke with a picture as its tip: the TxcImage */
    uint32_t visible;        /* 1 */
    float opacity;           /* 0 to 1; 1 */
    uint32_t blend;          /* TxcBlend; normal */
    uint32_t blend_space;    /* TxcBlendSpace; sRGB */
    uint32_t lock_alpha;     /* 0: 1 leaves the target's alpha as it was (an erasing layer then does nothing) */
    uint32_t filter;         /* TxcFilter; linear */
    uint32_t wrap;           /* TxcWrap; none */
    uint32_t flip_x;         /* 0: 1 mirrors the picture left to right */
    uint32_t flip_y;         /* 0 */
    uint32_t backfaces;      /* 0: 1 paints texels that face away too */
    float angle_fade_start;  /* degrees, 0 to 90; 70 */
    float angle_fade_end;    /* degrees, start to 90; 90 */
    uint32_t occlusion;      /* TxcOcclusion; self */
    uint32_t projector;      /* TxcProjector */
    float position_model[3]; /* metres; planar, cylindrical: the centre, perspective: the eye; not of uv */
    float rotation[4];       /* quaternion x, y, z, w; normalised by the core; not all 0; not of uv */
    float size[3];           /* planar: full extents, metres, above 0; 1 each */
    float fov_degrees;       /* perspective: vertical, above 0 and below 180; 45 */
    float aspect;            /* perspective: width by height, above 0; 1 */
    float near_distance;     /* perspective: metres before the eye, above 0; 0.1 */
    float far_distance;      /* perspective: metres, not below near_distance; 100 */
    float radius;            /* cylindrical: metres, above 0; 0.5 */
    float height;            /* cylindrical: full extent along the axis, metres, above 0; 1 */
    float arc_degrees;       /* cylindrical: width of the picture, above 0, at most 360; 180 */
    float depth;             /* cylindrical: how far from the radius, either side, metres, above 0; 0.1 */
    float uv_center[2];      /* uv: u and v; 1/2 each */
    float uv_size[2];        /* uv: full extents in u and v, above 0; 1 each */
    float uv_angle_degrees;  /* uv: clockwise as seen on the texture; 0 */
    float color[4];          /* fill, stroke: sRGB 0 to 1, straight alpha */
    uint32_t tip;            /* stroke: TxcTip; round */
    float hardness;          /* stroke with a round tip: the share of the radius that is solid, 0 to 1; 1 */
    float flow;              /* stroke: what share of the tip's alpha a dab lays down, 0 to 1; 1 */
    uint32_t parent;         /* TxcLayer that it is in; 0: the target's own list */
    uint32_t role;           /* TxcRole; content, which only a group has; a group cannot be part of a mask */
    uint32_t isolated;       /* group: 0; any blend but normal isolates too */
    uint32_t invert_mask;    /* 0: 1 takes the mask's alpha for what it lacks to 1 */
} TxcLayerDef;

TXC_API void txc_layer_def_default(TxcLayerDef* def);
/* Adds a layer on top of its parent's others. BAD_ARGUMENT for a parent that cannot have it, and beyond TXC_MAX_DEPTH. */
TXC_API TxcStatus txc_layer_create(TxcSession session, TxcTarget target, const TxcLayerDef* def, TxcLayer* out_layer);
/* Changes any field. Only a change of image, filter, wrap, flips, culling, fade, occlusion, projector or a stroke's brush
 * projects again; the rest recomposites. Under another parent, or in another role, it goes on top of the others there. A
 * layer that stops being a stroke loses its dabs, one that stops being a fill its gradient and triangles; a group must be empty
 * to become anything else. */
TXC_API TxcStatus txc_layer_update(TxcSession session, TxcLayer layer, const TxcLayerDef* def);
/* Puts the layer at `index` from the bottom of the list that it is in; an index past the top is the top. */
TXC_API TxcStatus txc_layer_move(TxcSession session, TxcLayer layer, uint32_t index);
/* Destroys the layer and all layers in it. */
TXC_API TxcStatus txc_layer_destroy(TxcSession session, TxcLayer layer);
/* Reads back what the layer was last given. */
TXC_API TxcStatus txc_layer_def(TxcSession session, TxcLayer layer, TxcLayerDef* out_def);

/* ---- Fills ------------------------------------------------------------------------------------------------------
 * A fill is one colour over the whole target. A gradient takes the colour from where a texel lies on the model, and a list of
 * triangles keeps the fill to those; with either, only texels of the model are painted, gutters with their triangle. */
typedef enum TxcGradientKind { TXC_GRADIENT_LINEAR, TXC_GRADIENT_RADIAL, TXC_GRADIENT_KIND_COUNT } TxcGradientKind;
/* Between stops colours are mixed premultiplied, in the layer's blend space; before the first and after the last one they
 * stay. Where two stops share an offset the colour jumps, from there on to that of the later. */
typedef struct TxcGradient {
    uint32_t kind;       /* TxcGradientKind */
    float from_model[3]; /* metres; linear: offset 0 is here, radial: the centre */
    float to_model[3];   /* linear: offset 1; not `from_model` */
    float radius;        /* radial: metres to offset 1, above 0 */
    uint32_t stop_count; /* 2 to TXC_MAX_STOPS */
    float offsets[16];   /* 0 to 1, none below the one before */
    float colors[64];    /* four a stop: sRGB 0 to 1, straight alpha */
} TxcGradient;
/* Linear, from the origin to +Y, black to white. */
TXC_API void txc_gradient_default(TxcGradient* gradient);
/* Null takes the gradient away. BAD_ARGUMENT for a layer of another kind. */
TXC_API TxcStatus txc_fill_set_gradient(TxcSession session, TxcLayer layer, const TxcGradient* gradient);
/* Triangles of the target's material, counted as txc_material_uvs has them, in any order. Null: everywhere. BAD_ARGUMENT for
 * one that is not there and for a layer of another kind; OUT_OF_BUDGET. */
TXC_API TxcStatus txc_fill_set_triangles(TxcSession session, TxcLayer layer, const uint32_t* triangles,
                                         uint32_t triangle_count);

/* ---- Strokes ----------------------------------------------------------------------------------------------------
 * A stroke is a brush's path over the surface: the layer's fields say what the brush is, its dabs where it touched. Each
 * dab lays the tip over those before it, by the layer's flow times its own (flow builds up); the whole is then laid on the
 * target once, by the layer's opacity and blend (opacity does not). The bytes do not depend on whether dabs came in one
 * call or in many, and an update paints those alone that came since the update before. */
typedef struct TxcDab {
    float flow;         /* 0 to 1: its share of the layer's flow, such as a pen's pressure; 1 */
    uint32_t flip_x;    /* 0: 1 turns the layer's flip_x round for this dab (a mirrored one's) */
    uint32_t projector; /* TxcProjector; this and all that follows as in TxcLayerDef */
    float position_model[3];
    float rotation[4];
    float size[3];
    float fov_degrees;
    float aspect;
    float near_distance;
    float far_distance;
    float radius;
    float height;
    float arc_degrees;
    float depth;
    float uv_center[2];
    float uv_size[2];
    float uv_angle_degrees;
} TxcDab;

TXC_API void txc_dab_default(TxcDab* dab);
/* Adds dabs after the stroke's others: all, or none where one is bad (the detail says which). BAD_ARGUMENT for a layer of
 * another kind and above TXC_MAX_DABS in all; OUT_OF_BUDGET. */
TXC_API TxcStatus txc_stroke_add_dabs(TxcSession session, TxcLayer layer, const TxcDab* dabs, uint32_t dab_count);
/* Takes all dabs away. */
TXC_API TxcStatus txc_stroke_clear(TxcSession session, TxcLayer layer);
TXC_API TxcStatus txc_stroke_dab_count(TxcSession session, TxcLayer layer, uint32_t* out_count);
/* Reads back dabs [first, first + dab_count) as they were given. */
TXC_API TxcStatus txc_stroke_dabs(TxcSession session, TxcLayer layer, uint32_t first, uint32_t dab_count,
                                  TxcDab* out_dabs);

/* ---- Update and read --------------------------------------------------------------------------------------------- */
typedef struct TxcRect {
    uint32_t x, y, width, height; /* texels of its level */
    uint32_t level;               /* 0 is the texture itself */
    uint32_t byte_offset; /* of its first row, with all rectangles packed one after another; rows are width * 4 */
} TxcRect;

typedef struct TxcUpdate {
    uint32_t rect_count;
    uint32_t byte_count;       /* of all rectangles, packed */
    uint32_t projected_layers; /* that this update projected */
    uint32_t projected_texels;
    uint32_t composited_texels;
    uint32_t unfinished; /* 1: layers wait that `work_limit` left no time for */
} TxcUpdate;

/* Projects the layers that changed, composites where they were and are, and finds the rectangles that changed since the
 * update before (the first one: everything). Rectangles of a level do not overlap. `work_limit`: of projections, in texels
 * about; TXC_NONE does all. What is left `unfinished` by it the next update goes on with, and until one is done the picture
 * stays as it was; a limit of 0 projects nothing, and shows what is there so far. */
TXC_API TxcStatus txc_target_update(TxcSession session, TxcTarget target, uint32_t work_limit, TxcUpdate* out_update);
/* Gets ready for changes of a layer that are likely to come, a drag or a stroke, so that the first of them is as quick as those
 * after it: keeps what lies below it on the tiles that it paints and those around them, within a quarter of the budget at
 * most. Changes no texel. `inside` 1: of a group, for what will be put on top in it, and for its mask. At most `tile_count`
 * tiles a call, from `first_tile` (0) on; `out_next_tile` is where to go on, TXC_NONE once there is no more to do. That is so
 * at once while something waits for an update, and for a layer that is not shown. */
TXC_API TxcStatus txc_layer_prepare(TxcSession session, TxcLayer layer, uint32_t inside, uint32_t first_tile,
                                    uint32_t tile_count, uint32_t* out_next_tile);
/* A small picture of what a layer paints, as of the newest update, for lists of layers: the square of the target around it,
 * `side` x `side` pixels (up to TXC_MAX_MINIATURE), RGBA, straight alpha. Without the layer's own opacity, mode and mask; in a
 * group all modes but erase are taken as normal. `of_mask` 1: of its mask instead, white where that shows the layer and black
 * where it hides it. */
#define TXC_MAX_MINIATURE 256u
TXC_API TxcStatus txc_layer_miniature(TxcSession session, TxcLayer layer, uint32_t of_mask, uint32_t side,
                                      uint8_t* out_rgba);
/* Of the newest update; they live until the target's next update or end. Null where there are none. */
TXC_API const TxcRect* txc_target_update_rects(TxcSession session, TxcTarget target);
/* All texels of a level as of the newest update, from which the host packs the rectangles for upload: RGBA, straight alpha,
 * row after row. They live until the target's next update or end. Null before the first update, or where there is no such level. */
TXC_API const uint8_t* txc_target_level(TxcSession session, TxcTarget target, uint32_t level);

/* Copies a rectangle of a level, as of the newest update. RGBA, straight alpha, rows packed. */
TXC_API TxcStatus txc_target_read(TxcSession session, TxcTarget target, uint32_t level, uint32_t x, uint32_t y,
                                  uint32_t width, uint32_t height, uint8_t* out_rgba);
/* Rows [row, row + row_count) of level 0 as of the newest update, as they are to be exported: colour bled outward from
 * charts that layers changed, 16 texels at 1024 and in proportion, never less. Errors: NOT_BAKED, OUT_OF_BUDGET. */
TXC_API TxcStatus txc_target_read_bled(TxcSession session, TxcTarget target, uint32_t row, uint32_t row_count,
                                       uint8_t* out_rgba);
/* FNV-1a, 64 bits, over the bytes that txc_target_read would give for level 0: out_hash[0] low, out_hash[1] high. */
TXC_API TxcStatus txc_target_hash(TxcSession session, TxcTarget target, uint32_t x, uint32_t y, uint32_t width,
                                  uint32_t height, uint32_t* out_hash);

/* ---- Print truth ------------------------------------------------------------------------------------------------
 * What becomes of layers on the surface, measured on the baked map. All is in metres of the model; what a print makes of them
 * is the host's to say. Formulas: docs/print-truth.md. */
typedef enum TxcZoneKind {
    TXC_ZONE_UV,  /* a polygon in the texture: first_corner, corner_count */
    TXC_ZONE_BOX, /* the surface in a box that faces its +Z: position, rotation, size */
    TXC_ZONE_KIND_COUNT
} TxcZoneKind;
/* Where a material may be printed. */
typedef struct TxcZone {
    uint32_t kind;         /* TxcZoneKind */
    uint32_t material;     /* glTF material index */
    uint32_t first_corner; /* uv: among the corners of all zones */
    uint32_t corner_count; /* uv: 3 or more */
    float position_model[3];
    float rotation[4]; /* quaternion x, y, z, w */
    float size[3];     /* full extents, metres, above 0; 1 each */
    float safe;        /* metres inside its edge that should stay free; 0 */
    float bleed;       /* metres beyond its edge that may be printed; 0 */
} TxcZone;

TXC_API void txc_zone_default(TxcZone* zone);
/* Takes these for the session's zones, in place of those before: up to TXC_MAX_ZONES. `corners_uv`: u and v a corner. They
 * change no texel. */
TXC_API TxcStatus txc_session_set_zones(TxcSession session, const TxcZone* zones, uint32_t zone_count,
                                        const float* corners_uv, uint32_t corner_count);
/* How much of each texel lies in a zone with its bleed (TXC_NONE: in any of the material's), 0 to 255, rows as
 * txc_map_read_coverage. */
TXC_API TxcStatus txc_zone_mask(TxcSession session, TxcTarget target, uint32_t zone, uint32_t row, uint32_t row_count,
                                uint8_t* out);

/* Means are weighted by area. */
typedef struct TxcZoneSurface {
    uint32_t texels;  /* covered ones whose centres lie in the zone or its bleed */
    uint32_t first_x; /* the rectangle of them, texels of the target */
    uint32_t first_y;
    uint32_t end_x;
    uint32_t end_y;
    float area;      /* square metres */
    float metric[3]; /* squared length of a texel to the right, its product with a texel down, squared length of that */
    float up[2];     /* where model space's +Y points, in texels */
    float mirrored;  /* the share that lies mirrored */
} TxcZoneSurface;
/* TXC_NONE: of all the material's surface. */
TXC_API TxcStatus txc_zone_surface(TxcSession session, TxcTarget target, uint32_t zone, TxcZoneSurface* out_surface);

/* Covered texels alone count; each with the layer's own alpha there. Least and greatest leave out what the angle fade takes
 * half or more of. Pixels, stretch, clipped and hidden are those of a decal's picture, else 0. */
typedef struct TxcLayerMetrics {
    float least_pixels_per_metre; /* along the way on which the picture is stretched most */
    float mean_pixels_per_metre;
    float least_texels_per_metre;
    float mean_texels_per_metre;
    float greatest_stretch; /* of a pixel, its longer side by its shorter, less 1 */
    float mean_stretch;
    float clipped;       /* share of the picture, by its alpha, that lands on no texel */
    float hidden;        /* share of it whose surface faces away or is occluded */
    float outside_zones; /* shares of the area */
    float in_safe_margin;
    uint32_t painted_texels;
    uint32_t overlapping_texels; /* that two places of the surface share */
    uint32_t mirrored_texels;
    float area; /* square metres */
} TxcLayerMetrics;
/* Measures one layer, or several that are one on several targets (the same picture, cast alike), as of the newest updates.
 * `out_zone_shares` (may be null): a float for each of the session's zones, the share of the area that lies in it.
 * BAD_ARGUMENT for a group, and for a layer that waits for an update. */
TXC_API TxcStatus txc_layer_metrics(TxcSession session, const TxcLayer* layers, uint32_t layer_count,
                                    TxcLayerMetrics* out_metrics, float* out_zone_shares);

/* What txc_layer_print_map gives for each texel that the layer paints; 0 elsewhere. */
typedef enum TxcPrintMap {
    TXC_PRINT_MAP_PIXELS,  /* of a decal's picture, a metre, where it is stretched most */
    TXC_PRINT_MAP_TEXELS,  /* the same of the texture */
    TXC_PRINT_MAP_STRETCH, /* of a decal's pixel: its longer side by its shorter */
    TXC_PRINT_MAP_COUNT
} TxcPrintMap;
TXC_API TxcStatus txc_layer_print_map(TxcSession session, TxcLayer layer, uint32_t kind, uint32_t row,
                                      uint32_t row_count, float* out);

#ifdef __cplusplus
}
#endif

#endif
