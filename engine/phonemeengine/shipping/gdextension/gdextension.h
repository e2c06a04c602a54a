/* SPDX-License-Identifier: MIT */
/*
 * What of Godot's interface for extensions the runtime uses: names, types and numbers as the engine has them since 4.2.
 * Values lie in memory as the engine's builds of single precision have them, which all of its own builds are.
 */
#ifndef GDEXTENSION_H
#define GDEXTENSION_H

#include <stddef.h>
#include <stdint.h>

/* Kinds of values. */
enum {
    GD_NOTHING, GD_BOOL, GD_INT, GD_FLOAT, GD_STRING, GD_STRING_NAME = 21, GD_BYTES = 29, GD_FLOATS = 32,
    GD_STRINGS = 34, GD_VECTORS = 35, GD_KINDS = 40
};
enum { GD_FLAG_NORMAL = 1, GD_USAGE_DEFAULT = 6 };
enum { GD_LEVEL_SCENE = 2 };
enum { GD_CALL_OK, GD_INVALID_METHOD, GD_INVALID_ARGUMENT, GD_TOO_MANY_ARGUMENTS, GD_TOO_FEW_ARGUMENTS };

typedef void *gd_name;   /* a StringName */
typedef void *gd_string; /* a String */
/* Room for a value of any kind that is used here, such as an array. */
typedef union {
    int64_t whole;
    double number;
    void *pointers[2];
} gd_value;

typedef struct {
    int error;
    int32_t argument, expected;
} gd_call_error;

typedef void (*gd_any)(void);
typedef gd_any (*gd_find)(const char *name);
typedef void (*gd_convert)(void *to, const void *from);
typedef void (*gd_construct)(void *made, const void *const *arguments);
typedef void (*gd_destroy)(void *value);
typedef void (*gd_built_in)(void *value, const void *const *arguments, void *result, int n);
typedef void (*gd_call)(
    void *of, void *self, const void *const *arguments, int64_t n, void *result, gd_call_error *error
);
typedef void (*gd_call_typed)(void *of, void *self, const void *const *arguments, void *result);

typedef struct {
    int kind;
    gd_name *name, *class_name;
    uint32_t hint;
    gd_string *hint_string;
    uint32_t usage;
} gd_property;

typedef struct {
    gd_name *name;
    void *of;
    gd_call call;
    gd_call_typed call_typed;
    uint32_t flags;
    uint8_t gives_something;
    gd_property *result;
    int result_width;
    uint32_t n_arguments;
    gd_property *arguments;
    int *argument_widths;
    uint32_t n_defaults;
    void **defaults;
} gd_method;

/* Functions that are not used have no type of their own here. */
typedef struct {
    uint8_t is_virtual, is_abstract, is_exposed;
    gd_any set, get, list_properties, free_properties, can_revert, get_revert, validate, notify, to_string, reference,
        unreference;
    void *(*create)(void *of);
    void (*free)(void *of, void *self);
    gd_any recreate, find_virtual, find_virtual_data, call_virtual, get_id;
    void *of;
} gd_class;

typedef struct {
    int level;
    void *of;
    void (*begin)(void *of, int level);
    void (*end)(void *of, int level);
} gd_start;

#endif
