/* SPDX-License-Identifier: MIT */
/*
 * The runtime as an extension of Godot 4: the class PhonemeRecogniser, which scripts use. A recogniser belongs to one
 * thread at a time. open() returns a sentence on what is wrong; without a model, and for frames that are not there,
 * the answers are those of silence.
 */
#include "gdextension.h"
#include "ear.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_ARGUMENTS = 3 };
static const char CLASS[] = "PhonemeRecogniser";

/* The functions of the engine, and what else is found once. */
static struct {
    void *library;
    void (*name_new)(void *made, const char *text, uint8_t lasts);
    void (*string_new)(void *made, const char *text);
    int64_t (*string_read)(const void *string, char *text, int64_t room);
    uint8_t (*can_convert)(int from, int to);
    int (*kind_of)(const void *variant);
    const uint8_t *(*bytes_at)(const void *bytes, int64_t k);
    const float *(*vectors_at)(const void *vectors, int64_t k);
    float *(*floats_at)(void *floats, int64_t k);
    gd_string *(*strings_at)(void *strings, int64_t k);
    void *(*construct)(const gd_name *parent);
    void (*set_instance)(void *object, const gd_name *name, void *self);
    void (*register_class)(void *library, const gd_name *name, const gd_name *parent, const gd_class *of);
    void (*register_method)(void *library, const gd_name *name, const gd_method *method);
    void (*unregister_class)(void *library, const gd_name *name);
    gd_convert to_variant[GD_KINDS], from_variant[GD_KINDS];
    gd_construct make[GD_KINDS];
    gd_destroy destroy[GD_KINDS];
    gd_built_in size[GD_KINDS], resize[GD_KINDS];
} gd;

typedef struct {
    ear_model *model;
    ear *listener;
    ear_mouth *mouth;
    ear_frame *frames; /* of the newest sound */
    size_t n_frames, room;
    uint32_t rate;
    int table, is_over;
} recogniser;

static const ear_frame SILENT = {.viseme = EAR_VISEME_SIL};

/* -- Values of the engine -- */

static void put_string(void *result, const char *text)
{
    gd.destroy[GD_STRING](result);
    gd.string_new(result, text);
}

static int64_t size_of(int kind, const void *array)
{
    int64_t n = 0;
    gd.size[kind]((void *)(size_t)array, NULL, &n, 0);
    return n;
}

static void resize(int kind, void *array, int64_t n)
{
    int64_t result;
    const void *arguments[1];
    arguments[0] = &n;
    gd.resize[kind](array, arguments, &result, 1);
}

static void put_floats(void *result, const float *values, size_t n)
{
    resize(GD_FLOATS, result, (int64_t)n);
    if (n)
        memcpy(gd.floats_at(result, 0), values, n * sizeof *values);
}

typedef const char *(*named)(const recogniser *self, int k);

static void put_names(void *result, const recogniser *self, int n, named name_of)
{
    int k;
    resize(GD_STRINGS, result, n);
    for (k = 0; k < n; k++)
        put_string(gd.strings_at(result, k), name_of(self, k));
}

/* -- Methods: arguments and result are values of the engine, of the kinds that METHODS says -- */

static void close_all(recogniser *self)
{
    ear_mouth_close(self->mouth);
    ear_close(self->listener);
    ear_model_close(self->model);
    free(self->frames);
    memset(self, 0, sizeof *self);
}

static const char *open_table(recogniser *self, const void *name)
{
    char text[256];
    int64_t n = gd.string_read(name, text, sizeof text - 1);
    text[n < 0 ? 0 : n < (int64_t)sizeof text ? n : (int64_t)sizeof text - 1] = '\0';
    self->table = ear_table_find(self->model, text);
    if (self->table < 0)
        return "the preset has no mouth table of this name; ship it with --table, or choose another";
    return ear_error_text(ear_mouth_open(self->model, self->table, 1, NULL, 0, &self->mouth));
}

static void open(recogniser *self, const void *const *arguments, void *result)
{
    int64_t n = size_of(GD_BYTES, arguments[0]), rate = *(const int64_t *)arguments[1];
    const char *wrong;
    int code;
    close_all(self);
    code = ear_model_open(n ? gd.bytes_at(arguments[0], 0) : (const uint8_t *)"", (size_t)n, NULL, 0, &self->model);
    self->rate = rate < 0 || rate > EAR_HIGHEST_RATE ? 0 : (uint32_t)rate;
    if (code == EAR_OK)
        code = ear_open(self->model, self->rate, NULL, 0, &self->listener);
    wrong = code == EAR_OK ? open_table(self, arguments[2]) : ear_error_text(code);
    if (!self->mouth)
        close_all(self);
    put_string(result, self->model ? "" : wrong);
}

/* A sound that is over begins again at 0, and so does the mouth's clock. */
static void begin_anew(recogniser *self)
{
    ear_mouth_close(self->mouth);
    self->mouth = NULL;
    if (ear_mouth_open(self->model, self->table, 1, NULL, 0, &self->mouth) != EAR_OK)
        close_all(self);
    self->is_over = 0;
}

static int has_room(recogniser *self, size_t n)
{
    ear_frame *more = self->frames;
    if (n > self->room && (more = realloc(self->frames, n * sizeof *more)) != NULL) {
        self->frames = more;
        self->room = n;
    }
    return more != NULL;
}

static void hear(recogniser *self, void *result)
{
    size_t k;
    for (k = 0; k < self->n_frames; k++) {
        const ear_frame *frame = &self->frames[k];
        ear_mouth_hear(self->mouth, frame->number / 100.0, frame->phoneme, frame->viseme, frame->intensity);
    }
    *(int64_t *)result = (int64_t)self->n_frames;
}

static void push(recogniser *self, const void *const *arguments, void *result)
{
    int64_t n = size_of(GD_VECTORS, arguments[0]);
    size_t most;
    *(int64_t *)result = 0;
    if (self->is_over)
        begin_anew(self);
    self->n_frames = 0;
    if (!self->model || !n)
        return;
    most = EAR_MOST_FRAMES(n, self->rate);
    if (!has_room(self, most))
        return;
    ear_push_channels(self->listener, gd.vectors_at(arguments[0], 0), (size_t)n, 2, self->frames, most, &self->n_frames);
    hear(self, result);
}

static void finish(recogniser *self, const void *const *arguments, void *result)
{
    (void)arguments;
    *(int64_t *)result = 0;
    self->n_frames = 0;
    if (!self->model || self->is_over || !has_room(self, EAR_LAST_FRAMES))
        return;
    ear_finish(self->listener, self->frames, EAR_LAST_FRAMES, &self->n_frames);
    hear(self, result);
    self->is_over = 1;
}

static void reset(recogniser *self, const void *const *arguments, void *result)
{
    (void)arguments;
    (void)result;
    self->n_frames = 0;
    if (!self->model)
        return;
    ear_reset(self->listener);
    begin_anew(self);
}

static void get_version(recogniser *self, const void *const *arguments, void *result)
{
    (void)self;
    (void)arguments;
    put_string(result, ear_version());
}

static void get_preset_name(recogniser *self, const void *const *arguments, void *result)
{
    (void)arguments;
    put_string(result, self->model ? ear_model_name(self->model) : "");
}

static void get_latency(recogniser *self, const void *const *arguments, void *result)
{
    (void)arguments;
    *(double *)result = self->listener ? ear_latency(self->listener) : 0;
}

static const char *phoneme_name(const recogniser *self, int k)
{
    (void)self;
    return ear_phoneme_name(k);
}

static const char *viseme_name(const recogniser *self, int k)
{
    return ear_model_viseme(self->model, k);
}

static const char *movestate_name(const recogniser *self, int k)
{
    return ear_table_movestate(self->model, self->table, k);
}

static void get_phonemes(recogniser *self, const void *const *arguments, void *result)
{
    (void)arguments;
    put_names(result, self, EAR_PHONEMES, phoneme_name);
}

static void get_visemes(recogniser *self, const void *const *arguments, void *result)
{
    (void)arguments;
    put_names(result, self, self->model ? ear_model_visemes(self->model) : 0, viseme_name);
}

static int n_movestates(const recogniser *self)
{
    return self->model ? ear_table_movestates(self->model, self->table) : 0;
}

static void get_movestates(recogniser *self, const void *const *arguments, void *result)
{
    (void)arguments;
    put_names(result, self, n_movestates(self), movestate_name);
}

static const ear_frame *frame_of(const recogniser *self, const void *const *arguments)
{
    int64_t k = *(const int64_t *)arguments[0];
    return k >= 0 && k < (int64_t)self->n_frames ? &self->frames[k] : &SILENT;
}

static void get_time(recogniser *self, const void *const *arguments, void *result)
{
    *(double *)result = frame_of(self, arguments)->number / 100.0;
}

static void get_phoneme(recogniser *self, const void *const *arguments, void *result)
{
    put_string(result, ear_phoneme_name(frame_of(self, arguments)->phoneme));
}

static void get_viseme(recogniser *self, const void *const *arguments, void *result)
{
    int viseme = frame_of(self, arguments)->viseme;
    put_string(result, self->model ? ear_model_viseme(self->model, viseme) : "");
}

static void get_intensity(recogniser *self, const void *const *arguments, void *result)
{
    *(double *)result = frame_of(self, arguments)->intensity;
}

static void get_confidence(recogniser *self, const void *const *arguments, void *result)
{
    *(double *)result = frame_of(self, arguments)->confidence;
}

static void get_shape(recogniser *self, const void *const *arguments, void *result)
{
    const ear_frame *frame = frame_of(self, arguments);
    const char *name = "";
    if (self->model) {
        int shape = ear_table_shape(self->model, self->table, frame->phoneme, frame->viseme);
        name = ear_table_shape_name(self->model, self->table, shape);
    }
    put_string(result, name);
}

static void get_phoneme_scores(recogniser *self, const void *const *arguments, void *result)
{
    put_floats(result, frame_of(self, arguments)->scores, EAR_PHONEMES);
}

static void get_viseme_scores(recogniser *self, const void *const *arguments, void *result)
{
    size_t n = self->model ? (size_t)ear_model_visemes(self->model) : 0;
    put_floats(result, frame_of(self, arguments)->viseme_scores, n);
}

static void get_blend(recogniser *self, const void *const *arguments, void *result)
{
    int n = n_movestates(self);
    resize(GD_FLOATS, result, n);
    if (n)
        ear_table_blend(self->model, self->table, frame_of(self, arguments), gd.floats_at(result, 0));
}

static void get_weights(recogniser *self, const void *const *arguments, void *result)
{
    int n = n_movestates(self);
    resize(GD_FLOATS, result, n);
    if (n)
        ear_mouth_weights(self->mouth, *(const double *)arguments[0], gd.floats_at(result, 0));
}

typedef struct {
    const char *name;
    void (*body)(recogniser *self, const void *const *arguments, void *result);
    int result, n_arguments;
    struct {
        const char *name;
        int kind;
    } arguments[MOST_ARGUMENTS];
} method;

#define OF_A_FRAME 1, {{"frame", GD_INT}}

static const method METHODS[] = {
    {"open", open, GD_STRING, 3, {{"preset", GD_BYTES}, {"rate", GD_INT}, {"table", GD_STRING}}},
    {"push", push, GD_INT, 1, {{"sound", GD_VECTORS}}},
    {"finish", finish, GD_INT, 0, {{NULL, 0}}},
    {"reset", reset, GD_NOTHING, 0, {{NULL, 0}}},
    {"get_version", get_version, GD_STRING, 0, {{NULL, 0}}},
    {"get_preset_name", get_preset_name, GD_STRING, 0, {{NULL, 0}}},
    {"get_latency", get_latency, GD_FLOAT, 0, {{NULL, 0}}},
    {"get_phonemes", get_phonemes, GD_STRINGS, 0, {{NULL, 0}}},
    {"get_visemes", get_visemes, GD_STRINGS, 0, {{NULL, 0}}},
    {"get_movestates", get_movestates, GD_STRINGS, 0, {{NULL, 0}}},
    {"get_time", get_time, GD_FLOAT, OF_A_FRAME},
    {"get_phoneme", get_phoneme, GD_STRING, OF_A_FRAME},
    {"get_viseme", get_viseme, GD_STRING, OF_A_FRAME},
    {"get_intensity", get_intensity, GD_FLOAT, OF_A_FRAME},
    {"get_confidence", get_confidence, GD_FLOAT, OF_A_FRAME},
    {"get_shape", get_shape, GD_STRING, OF_A_FRAME},
    {"get_phoneme_scores", get_phoneme_scores, GD_FLOATS, OF_A_FRAME},
    {"get_viseme_scores", get_viseme_scores, GD_FLOATS, OF_A_FRAME},
    {"get_blend", get_blend, GD_FLOATS, OF_A_FRAME},
    {"get_weights", get_weights, GD_FLOATS, 1, {{"time", GD_FLOAT}}},
};
enum { N_METHODS = sizeof METHODS / sizeof *METHODS };
static const int KINDS[] = {GD_INT, GD_FLOAT, GD_STRING, GD_STRING_NAME, GD_BYTES, GD_FLOATS, GD_STRINGS, GD_VECTORS};
enum { N_KINDS = sizeof KINDS / sizeof *KINDS };

/* -- The engine's side: calls, the class, and the start -- */

static void call_typed(void *of, void *self, const void *const *arguments, void *result)
{
    ((const method *)of)->body(self, arguments, result);
}

static int is_callable(const method *of, const void *const *arguments, int64_t n, gd_call_error *error)
{
    int k;
    error->error = n < of->n_arguments ? GD_TOO_FEW_ARGUMENTS : n > of->n_arguments ? GD_TOO_MANY_ARGUMENTS : GD_CALL_OK;
    error->expected = of->n_arguments;
    for (k = 0; error->error == GD_CALL_OK && k < of->n_arguments; k++) {
        if (gd.can_convert(gd.kind_of(arguments[k]), of->arguments[k].kind))
            continue;
        error->error = GD_INVALID_ARGUMENT;
        error->argument = k;
        error->expected = of->arguments[k].kind;
    }
    return error->error == GD_CALL_OK;
}

static void destroy(int kind, void *value)
{
    if (gd.destroy[kind])
        gd.destroy[kind](value);
}

static void
call(void *data, void *self, const void *const *arguments, int64_t n, void *result, gd_call_error *error)
{
    const method *of = data;
    gd_value values[MOST_ARGUMENTS], made;
    const void *places[MOST_ARGUMENTS];
    int k;
    if (!is_callable(of, arguments, n, error))
        return;
    for (k = 0; k < of->n_arguments; k++) {
        gd.from_variant[of->arguments[k].kind](&values[k], arguments[k]);
        places[k] = &values[k];
    }
    if (of->result)
        gd.make[of->result](&made, NULL);
    of->body(self, places, &made);
    for (k = 0; k < of->n_arguments; k++)
        destroy(of->arguments[k].kind, &values[k]);
    if (of->result) {
        gd.to_variant[of->result](result, &made);
        destroy(of->result, &made);
    }
}

static void *create(void *of)
{
    recogniser *self = calloc(1, sizeof *self);
    gd_name name, parent;
    void *object;
    (void)of;
    if (!self)
        return NULL;
    gd.name_new(&name, CLASS, 0);
    gd.name_new(&parent, "RefCounted", 0);
    object = gd.construct(&parent);
    gd.set_instance(object, &name, self);
    destroy(GD_STRING_NAME, &parent);
    destroy(GD_STRING_NAME, &name);
    return object;
}

static void free_one(void *of, void *self)
{
    (void)of;
    close_all(self);
    free(self);
}

static void register_method(const gd_name *class_name, const method *of)
{
    gd_name names[MOST_ARGUMENTS + 1], none;
    gd_string no_hint;
    gd_property properties[MOST_ARGUMENTS + 1]; /* the last one: of the result */
    int widths[MOST_ARGUMENTS] = {0}, k;
    gd_method made = {0};
    gd.name_new(&none, "", 0);
    gd.string_new(&no_hint, "");
    for (k = 0; k <= MOST_ARGUMENTS; k++) {
        int is_argument = k < of->n_arguments;
        gd_property property = {0};
        gd.name_new(&names[k], is_argument ? of->arguments[k].name : "", 0);
        property.kind = is_argument ? of->arguments[k].kind : of->result;
        property.name = &names[k];
        property.class_name = &none;
        property.hint_string = &no_hint;
        property.usage = GD_USAGE_DEFAULT;
        properties[k] = property;
    }
    gd.destroy[GD_STRING_NAME](&names[MOST_ARGUMENTS]);
    gd.name_new(&names[MOST_ARGUMENTS], of->name, 0);
    made.name = &names[MOST_ARGUMENTS];
    made.of = (void *)(size_t)of;
    made.call = call;
    made.call_typed = call_typed;
    made.flags = GD_FLAG_NORMAL;
    made.gives_something = of->result != GD_NOTHING;
    properties[MOST_ARGUMENTS].name = &none;
    made.result = &properties[MOST_ARGUMENTS];
    made.n_arguments = (uint32_t)of->n_arguments;
    made.arguments = properties;
    made.argument_widths = widths;
    gd.register_method(gd.library, class_name, &made);
    for (k = 0; k <= MOST_ARGUMENTS; k++)
        destroy(GD_STRING_NAME, &names[k]);
    destroy(GD_STRING_NAME, &none);
    destroy(GD_STRING, &no_hint);
}

static void begin(void *of, int level)
{
    gd_name name, parent;
    gd_class made = {0};
    int k;
    (void)of;
    if (level != GD_LEVEL_SCENE)
        return;
    made.is_exposed = 1;
    made.create = create;
    made.free = free_one;
    gd.name_new(&name, CLASS, 0);
    gd.name_new(&parent, "RefCounted", 0);
    gd.register_class(gd.library, &name, &parent, &made);
    for (k = 0; k < N_METHODS; k++)
        register_method(&name, &METHODS[k]);
    destroy(GD_STRING_NAME, &parent);
    destroy(GD_STRING_NAME, &name);
}

static void end(void *of, int level)
{
    gd_name name;
    (void)of;
    if (level != GD_LEVEL_SCENE)
        return;
    gd.name_new(&name, CLASS, 0);
    gd.unregister_class(gd.library, &name);
    destroy(GD_STRING_NAME, &name);
}

/* Put a function of the engine where its type is known. */
static int put_function(void *place, gd_any found)
{
    memcpy(place, &found, sizeof found);
    return found != NULL;
}

#define FETCH(place, name) (is_whole &= put_function(&(place), find(name)))

static int find_kinds(gd_find find)
{
    gd_convert (*to_variant)(int);
    gd_convert (*from_variant)(int);
    gd_construct (*constructor)(int, int32_t);
    gd_destroy (*destructor)(int);
    gd_built_in (*built_in)(int, const gd_name *, int64_t);
    gd_name size, resize_name;
    int is_whole = 1, k;
    FETCH(to_variant, "get_variant_from_type_constructor");
    FETCH(from_variant, "get_variant_to_type_constructor");
    FETCH(constructor, "variant_get_ptr_constructor");
    FETCH(destructor, "variant_get_ptr_destructor");
    FETCH(built_in, "variant_get_ptr_builtin_method");
    if (!is_whole)
        return 0;
    gd.name_new(&size, "size", 0);
    gd.name_new(&resize_name, "resize", 0);
    for (k = 0; k < N_KINDS; k++) {
        int kind = KINDS[k];
        gd.to_variant[kind] = to_variant(kind);
        gd.from_variant[kind] = from_variant(kind);
        gd.make[kind] = constructor(kind, 0);
        gd.destroy[kind] = destructor(kind);
        if (kind < GD_BYTES)
            continue;
        gd.size[kind] = built_in(kind, &size, 3173160232);
        gd.resize[kind] = built_in(kind, &resize_name, 848867239);
        is_whole &= gd.size[kind] && gd.resize[kind];
    }
    destroy(GD_STRING_NAME, &resize_name);
    destroy(GD_STRING_NAME, &size);
    return is_whole;
}

EAR_API uint8_t ear_godot(gd_find find, void *library, gd_start *start);

/* What Godot calls, by the name in phoneme_ear.gdextension; 0 where the engine lacks a function. */
EAR_API uint8_t ear_godot(gd_find find, void *library, gd_start *start)
{
    int is_whole = 1;
    gd.library = library;
    FETCH(gd.name_new, "string_name_new_with_latin1_chars");
    FETCH(gd.string_new, "string_new_with_utf8_chars");
    FETCH(gd.string_read, "string_to_utf8_chars");
    FETCH(gd.can_convert, "variant_can_convert_strict");
    FETCH(gd.kind_of, "variant_get_type");
    FETCH(gd.bytes_at, "packed_byte_array_operator_index_const");
    FETCH(gd.vectors_at, "packed_vector2_array_operator_index_const");
    FETCH(gd.floats_at, "packed_float32_array_operator_index");
    FETCH(gd.strings_at, "packed_string_array_operator_index");
    FETCH(gd.construct, "classdb_construct_object");
    FETCH(gd.set_instance, "object_set_instance");
    FETCH(gd.register_class, "classdb_register_extension_class2");
    FETCH(gd.register_method, "classdb_register_extension_class_method");
    FETCH(gd.unregister_class, "classdb_unregister_extension_class");
    start->level = GD_LEVEL_SCENE;
    start->of = NULL;
    start->begin = begin;
    start->end = end;
    return is_whole && find_kinds(find);
}
