/*
 * Plays Godot's side of the interface for extensions, and has the class PhonemeRecogniser hear what comes on the standard
 * input as float32: godot_host LIBRARY PRESET RATE TABLE. Writes for each frame phoneme, viseme, intensity and confidence,
 * the scores of phonemes and visemes, and the blend, as float64. Values that are not destroyed, and
 * methods that are not as they are registered, are errors. Strings and arrays are counted blocks of bytes.
 */
#include "gdextension.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 32, BLOCK = 441, MOST_BYTES = 1 << 23 };

typedef struct {
    int64_t n;
    char bytes[];
} block;

typedef struct {
    int kind;
    gd_value value;
    int64_t rest;
} variant;

static int n_blocks; /* that are in use */
static struct {
    char name[64];
    gd_method of;
    int kinds[4];
} methods[MOST];
static int n_methods;
static gd_class made;
static void *instance;

static void check(int is_so, const char *words)
{
    if (is_so)
        return;
    fprintf(stderr, "%s\n", words);
    exit(1);
}

static block *block_of(const void *bytes, int64_t n)
{
    block *found = calloc(1, sizeof *found + (size_t)n + 1);
    found->n = n;
    if (bytes)
        memcpy(found->bytes, bytes, (size_t)n);
    n_blocks++;
    return found;
}

/* An array is the second of its two pointers; a string, and a name, is one pointer. Empty ones have no block. */
static block **place_of(int kind, void *value)
{
    return &((block **)value)[kind >= GD_BYTES];
}

static int width_of(int kind)
{
    return kind == GD_FLOATS ? 4 : kind == GD_VECTORS ? 8 : kind == GD_STRINGS ? (int)sizeof(gd_string) : 1;
}

static void empty(int kind, void *value)
{
    memset(value, 0, kind >= GD_BYTES ? 16 : 8);
}

static void destroy(int kind, void *value)
{
    block *of = *place_of(kind, value);
    int64_t k;
    if (!of)
        return;
    for (k = 0; kind == GD_STRINGS && k < of->n; k += (int64_t)sizeof(gd_string))
        destroy(GD_STRING, of->bytes + k);
    free(of);
    n_blocks--;
    empty(kind, value);
}

static void copy(int kind, void *to, const void *from)
{
    block *of = *place_of(kind, (void *)(size_t)from);
    int64_t k;
    empty(kind, to);
    if (!of)
        return;
    *place_of(kind, to) = block_of(of->bytes, of->n);
    for (k = 0; kind == GD_STRINGS && k < of->n; k += (int64_t)sizeof(gd_string))
        copy(GD_STRING, (*place_of(kind, to))->bytes + k, of->bytes + k);
}

static void string_new(void *to, const char *text)
{
    *(block **)to = *text ? block_of(text, (int64_t)strlen(text)) : NULL;
}

static void name_new(void *to, const char *text, uint8_t lasts)
{
    check(!lasts, "a name that lasts may not be destroyed");
    string_new(to, text);
}

static const char *text_of(const void *string)
{
    const block *of = *(block *const *)string;
    return of ? of->bytes : "";
}

static int64_t string_read(const void *string, char *text, int64_t room)
{
    int64_t n = (int64_t)strlen(text_of(string));
    memcpy(text, text_of(string), (size_t)(n < room ? n : room));
    return n;
}

static uint8_t can_convert(int from, int to)
{
    return from == to || (from == GD_INT && to == GD_FLOAT);
}

static int kind_of(const void *of)
{
    return ((const variant *)of)->kind;
}

static void *at(int kind, void *array, int64_t k)
{
    block *of = *place_of(kind, array);
    check(of && k >= 0 && k * width_of(kind) < of->n, "an element that is not there");
    return of->bytes + k * width_of(kind);
}

static void *bytes_at(void *array, int64_t k) { return at(GD_BYTES, array, k); }
static void *vectors_at(void *array, int64_t k) { return at(GD_VECTORS, array, k); }
static void *floats_at(void *array, int64_t k) { return at(GD_FLOATS, array, k); }
static void *strings_at(void *array, int64_t k) { return at(GD_STRINGS, array, k); }

/* Functions that the engine hands out for a kind do not get it as an argument, so there is one for each kind. */
#define KIND(name, of_kind)                                                                                            \
    static void name##_to_variant(void *to, const void *from)                                                          \
    {                                                                                                                  \
        ((variant *)to)->kind = of_kind;                                                                               \
        of_kind == GD_INT || of_kind == GD_FLOAT ? (void)memcpy(&((variant *)to)->value, from, 8)                      \
                                           : copy(of_kind, &((variant *)to)->value, from);                             \
    }                                                                                                                  \
    static void name##_from_variant(void *to, const void *from)                                                        \
    {                                                                                                                  \
        const variant *of = from;                                                                                      \
        if (of_kind == GD_FLOAT && of->kind == GD_INT)                                                                 \
            *(double *)to = (double)of->value.whole;                                                                   \
        else if (of_kind == GD_INT || of_kind == GD_FLOAT)                                                             \
            memcpy(to, &of->value, 8);                                                                                 \
        else                                                                                                           \
            copy(of_kind, to, &of->value);                                                                             \
    }                                                                                                                  \
    static void name##_make(void *to, const void *const *arguments)                                                    \
    {                                                                                                                  \
        check(!arguments, "an empty value needs nothing");                                                             \
        empty(of_kind, to);                                                                                            \
    }                                                                                                                  \
    static void name##_destroy(void *value) { destroy(of_kind, value); }                                               \
    static void name##_size(void *value, const void *const *arguments, void *result, int n)                            \
    {                                                                                                                  \
        block *of = *place_of(of_kind, value);                                                                         \
        check(!arguments && n == 0, "size needs nothing");                                                             \
        *(int64_t *)result = of ? of->n / width_of(of_kind) : 0;                                                       \
    }                                                                                                                  \
    static void name##_resize(void *value, const void *const *arguments, void *result, int n)                          \
    {                                                                                                                  \
        int64_t length = *(const int64_t *)arguments[0] * width_of(of_kind);                                           \
        block **of = place_of(of_kind, value);                                                                         \
        check(n == 1 && !*of, "an array of a result is empty");                                                        \
        *of = length ? block_of(NULL, length) : NULL;                                                                  \
        *(int64_t *)result = 0;                                                                                        \
    }
KIND(int, GD_INT)
KIND(float, GD_FLOAT)
KIND(string, GD_STRING)
KIND(name, GD_STRING_NAME)
KIND(bytes, GD_BYTES)
KIND(floats, GD_FLOATS)
KIND(strings, GD_STRINGS)
KIND(vectors, GD_VECTORS)

static const struct {
    int kind;
    gd_convert to_variant, from_variant;
    gd_construct make;
    gd_destroy destroy;
    gd_built_in size, resize;
} KINDS[] = {
#define ROW(name, of_kind)                                                                                              \
    {of_kind, name##_to_variant, name##_from_variant, name##_make, name##_destroy, name##_size, name##_resize}
    ROW(int, GD_INT), ROW(float, GD_FLOAT), ROW(string, GD_STRING), ROW(name, GD_STRING_NAME), ROW(bytes, GD_BYTES),
    ROW(floats, GD_FLOATS), ROW(strings, GD_STRINGS), ROW(vectors, GD_VECTORS),
};

static int row_of(int kind)
{
    int k = 0;
    while (KINDS[k].kind != kind)
        k++;
    return k;
}

static gd_convert to_variant(int kind) { return KINDS[row_of(kind)].to_variant; }
static gd_convert from_variant(int kind) { return KINDS[row_of(kind)].from_variant; }
static gd_destroy destructor(int kind) { return kind == GD_INT || kind == GD_FLOAT ? NULL : KINDS[row_of(kind)].destroy; }

static gd_construct constructor(int kind, int32_t which)
{
    check(which == 0, "the first constructor makes empty values");
    return KINDS[row_of(kind)].make;
}

static gd_built_in built_in(int kind, const gd_name *name, int64_t hash)
{
    int is_size = strcmp(text_of(name), "size") == 0;
    check(hash == (is_size ? 3173160232 : 848867239), "a built-in method of another engine");
    return is_size ? KINDS[row_of(kind)].size : KINDS[row_of(kind)].resize;
}

static void *construct(const gd_name *parent)
{
    check(strcmp(text_of(parent), "RefCounted") == 0, "another parent");
    return &instance;
}

static void set_instance(void *object, const gd_name *name, void *self)
{
    check(object == &instance && strcmp(text_of(name), "PhonemeRecogniser") == 0, "another object");
    instance = self;
}

static void register_class(void *library, const gd_name *name, const gd_name *parent, const gd_class *of)
{
    check(library == &made && strcmp(text_of(name), "PhonemeRecogniser") == 0, "another class");
    check(strcmp(text_of(parent), "RefCounted") == 0 && of->is_exposed && !of->is_virtual && !of->is_abstract, "class");
    made = *of;
}

static void register_method(void *library, const gd_name *class_name, const gd_method *of)
{
    uint32_t k;
    check(library == &made && strcmp(text_of(class_name), "PhonemeRecogniser") == 0 && n_methods < MOST, "methods");
    strcpy(methods[n_methods].name, text_of(of->name));
    methods[n_methods].of = *of;
    for (k = 0; k < of->n_arguments; k++) {
        check(*text_of(of->arguments[k].name) && of->arguments[k].usage == GD_USAGE_DEFAULT, "an argument needs a name");
        check(!*text_of(of->arguments[k].class_name) && !*text_of(of->arguments[k].hint_string), "a hint");
        methods[n_methods].kinds[k] = of->arguments[k].kind;
    }
    methods[n_methods].kinds[3] = of->gives_something ? of->result->kind : GD_NOTHING;
    n_methods++;
}

static void unregister_class(void *library, const gd_name *name)
{
    check(library == &made && strcmp(text_of(name), "PhonemeRecogniser") == 0, "another class ends");
    n_methods = 0;
}

static gd_any find(const char *name)
{
    static const struct {
        const char *name;
        gd_any function;
    } known[] = {
#define HAS(name, function) {name, (gd_any)function}
        HAS("string_name_new_with_latin1_chars", name_new),
        HAS("string_new_with_utf8_chars", string_new),
        HAS("string_to_utf8_chars", string_read),
        HAS("variant_can_convert_strict", can_convert),
        HAS("variant_get_type", kind_of),
        HAS("packed_byte_array_operator_index_const", bytes_at),
        HAS("packed_vector2_array_operator_index_const", vectors_at),
        HAS("packed_float32_array_operator_index", floats_at),
        HAS("packed_string_array_operator_index", strings_at),
        HAS("classdb_construct_object", construct),
        HAS("object_set_instance", set_instance),
        HAS("classdb_register_extension_class2", register_class),
        HAS("classdb_register_extension_class_method", register_method),
        HAS("classdb_unregister_extension_class", unregister_class),
        HAS("get_variant_from_type_constructor", to_variant),
        HAS("get_variant_to_type_constructor", from_variant),
        HAS("variant_get_ptr_constructor", constructor),
        HAS("variant_get_ptr_destructor", destructor),
        HAS("variant_get_ptr_builtin_method", built_in),
    };
    size_t k;
    for (k = 0; k < sizeof known / sizeof *known; k++)
        if (strcmp(known[k].name, name) == 0)
            return known[k].function;
    return NULL;
}

static int number_of(const char *name)
{
    int k = 0;
    while (k < n_methods && strcmp(methods[k].name, name) != 0)
        k++;
    check(k < n_methods, name);
    return k;
}

/* Call a method as a script does whose types are known, and as one does whose types are not: both give the same. */
static gd_value ask(const char *name, int n, gd_value *arguments, int is_typed)
{
    int number = number_of(name), kind = methods[number].kinds[3], k;
    const void *places[3];
    variant variants[3], result = {0};
    gd_call_error error = {0};
    if (is_typed) {
        if (kind)
            empty(kind, &result.value);
        for (k = 0; k < n; k++)
            places[k] = &arguments[k];
        methods[number].of.call_typed(methods[number].of.of, instance, places, &result.value);
        return result.value;
    }
    for (k = 0; k < n; k++) {
        to_variant(methods[number].kinds[k])(&variants[k], &arguments[k]);
        places[k] = &variants[k];
    }
    methods[number].of.call(methods[number].of.of, instance, places, n, &result, &error);
    check(error.error == GD_CALL_OK && result.kind == kind, name);
    for (k = 0; k < n; k++)
        if (variants[k].kind != GD_INT && variants[k].kind != GD_FLOAT)
            destroy(variants[k].kind, &variants[k].value);
    return result.value;
}

static int calls; /* so that both ways take turns */

static gd_value of_frame(const char *name, int64_t frame)
{
    gd_value argument;
    argument.whole = frame;
    return ask(name, 1, &argument, calls++ % 2);
}

static void write_number(double number)
{
    fwrite(&number, sizeof number, 1, stdout);
}

static void write_floats(gd_value floats)
{
    int64_t n, k;
    floats_size(&floats, NULL, &n, 0);
    for (k = 0; k < n; k++)
        write_number(*(float *)floats_at(&floats, k));
    destroy(GD_FLOATS, &floats);
}

/* Write the place of a name in a list; -1 where it is not there. */
static void write_place(gd_value name, gd_value *names)
{
    int64_t n, k, found = -1;
    strings_size(names, NULL, &n, 0);
    for (k = 0; k < n; k++)
        if (strcmp(text_of(strings_at(names, k)), text_of(&name)) == 0)
            found = k;
    destroy(GD_STRING, &name);
    write_number((double)found);
}

static void write_frames(int64_t n, gd_value *phonemes, gd_value *visemes)
{
    int64_t k;
    for (k = 0; k < n; k++) {
        write_place(of_frame("get_phoneme", k), phonemes);
        write_place(of_frame("get_viseme", k), visemes);
        write_number(of_frame("get_intensity", k).number);
        write_number(of_frame("get_confidence", k).number);
        write_floats(of_frame("get_phoneme_scores", k));
        write_floats(of_frame("get_viseme_scores", k));
        write_floats(of_frame("get_blend", k));
    }
}

static void hear(gd_value *phonemes, gd_value *visemes)
{
    static float samples[BLOCK];
    static float both[2 * BLOCK];
    size_t n, k;
    gd_value sound, time = {0}, weights;
    while ((n = fread(samples, sizeof *samples, BLOCK, stdin)) > 0) {
        for (k = 0; k < n; k++)
            both[2 * k] = both[2 * k + 1] = samples[k];
        empty(GD_VECTORS, &sound);
        *place_of(GD_VECTORS, &sound) = block_of(both, (int64_t)(n * 8));
        write_frames(ask("push", 1, &sound, calls % 2).whole, phonemes, visemes);
        destroy(GD_VECTORS, &sound);
        time.number += 0.01;
        weights = ask("get_weights", 1, &time, calls % 2);
        destroy(GD_FLOATS, &weights);
    }
    write_frames(ask("finish", 0, NULL, 1).whole, phonemes, visemes);
}

static void check_mistakes(void)
{
    int number = number_of("push");
    variant wrong = {GD_STRING, {0}, 0}, result = {0};
    const void *places[2] = {&wrong, &wrong};
    gd_call_error error = {0};
    methods[number].of.call(methods[number].of.of, instance, places, 0, &result, &error);
    check(error.error == GD_TOO_FEW_ARGUMENTS && error.expected == 1, "too few arguments");
    methods[number].of.call(methods[number].of.of, instance, places, 2, &result, &error);
    check(error.error == GD_TOO_MANY_ARGUMENTS, "too many arguments");
    methods[number].of.call(methods[number].of.of, instance, places, 1, &result, &error);
    check(error.error == GD_INVALID_ARGUMENT && error.argument == 0 && error.expected == GD_VECTORS, "another kind");
    check(of_frame("get_intensity", 99).number == 0, "a frame that is not there is silent");
}

int main(int n_words, char **words)
{
    static char bytes[MOST_BYTES];
    void *library = n_words == 5 ? dlopen(words[1], RTLD_NOW) : NULL;
    FILE *file = library ? fopen(words[2], "rb") : NULL;
    uint8_t (*entry)(gd_find, void *, gd_start *);
    void *symbol = NULL;
    gd_start start = {0};
    size_t n_bytes;
    gd_value arguments[3], said, phonemes, visemes;
    check(library != NULL, n_words == 5 ? dlerror() : "LIBRARY PRESET RATE TABLE");
    check(file != NULL && (symbol = dlsym(library, "ear_godot")) != NULL, "no preset, or no entry");
    memcpy(&entry, &symbol, sizeof entry);
    check(entry(find, &made, &start) && start.level == GD_LEVEL_SCENE, "the extension does not start");
    start.begin(start.of, 0);
    check(n_methods == 0, "too early");
    start.begin(start.of, GD_LEVEL_SCENE);
    check(made.create(made.of) == &instance, "no object");
    check_mistakes();
    empty(GD_BYTES, &arguments[0]);
    n_bytes = fread(bytes, 1, sizeof bytes, file);
    *place_of(GD_BYTES, &arguments[0]) = block_of(bytes, (int64_t)n_bytes);
    arguments[1].whole = atol(words[3]);
    string_new(&arguments[2], words[4]);
    said = ask("open", 3, arguments, 0);
    destroy(GD_BYTES, &arguments[0]);
    destroy(GD_STRING, &arguments[2]);
    fputs(text_of(&said), stderr);
    if (!*text_of(&said)) {
        phonemes = ask("get_phonemes", 0, NULL, 0);
        visemes = ask("get_visemes", 0, NULL, 1);
        hear(&phonemes, &visemes);
        destroy(GD_STRINGS, &phonemes);
        destroy(GD_STRINGS, &visemes);
    }
    destroy(GD_STRING, &said);
    made.free(made.of, instance);
    start.end(start.of, GD_LEVEL_SCENE);
    check(n_blocks == 0, "values are left");
    fclose(file);
    return 0;
}
