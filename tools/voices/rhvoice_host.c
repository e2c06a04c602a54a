/* Speaks lines with RHVoice.dll: a console program for Windows, or for wine.
 *
 *   rhvoice_host RHVoice.dll DATA_DIR CONFIG_DIR < jobs
 *
 * A job is one line: profile TAB rate TAB pitch TAB output file TAB text (UTF-8). Rate and pitch are factors.
 * The output is raw 16 bit mono; its rate in hertz is printed, one line a job, after the sample count.
 * The structures below are those of version 1.14 of the library's C interface.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>

typedef struct {
    int (*set_sample_rate)(int rate, void *user);
    int (*play_speech)(const short *samples, unsigned int count, void *user);
    int (*process_mark)(const char *name, void *user);
    int (*word_starts)(unsigned int position, unsigned int length, void *user);
    int (*word_ends)(unsigned int position, unsigned int length, void *user);
    int (*sentence_starts)(unsigned int position, unsigned int length, void *user);
    int (*sentence_ends)(unsigned int position, unsigned int length, void *user);
    int (*play_audio)(const char *source, void *user);
    void (*done)(void *user);
} Callbacks;

typedef struct {
    const char *data_path, *config_path;
    const char **resource_paths;
    Callbacks callbacks;
    unsigned int options;
} InitParams;

typedef struct {
    const char *voice_profile;
    double absolute_rate, absolute_pitch, absolute_volume, relative_rate, relative_pitch, relative_volume;
    int punctuation_mode;
    const char *punctuation_list;
    int capitals_mode, flags;
} SynthParams;

typedef struct {
    FILE *file;
    int rate;
    unsigned long count;
} Output;

static int set_sample_rate(int rate, void *user)
{
    ((Output *)user)->rate = rate;
    return 1;
}

static int play_speech(const short *samples, unsigned int count, void *user)
{
    Output *output = user;
    output->count += count;
    return fwrite(samples, sizeof *samples, count, output->file) == count;
}

static void done(void *user)
{
    (void)user;
}

static char *next_field(char **rest)
{
    char *field = *rest, *tab = field ? strchr(field, '\t') : NULL;
    if (tab)
        *tab++ = '\0';
    *rest = tab;
    return field;
}

int main(int argc, char **argv)
{
    static char line[65536];
    if (argc != 4)
        return 2;
    HMODULE library = LoadLibraryA(argv[1]);
    if (!library)
        return 3;
    void *(*new_engine)(const InitParams *) = (void *)GetProcAddress(library, "RHVoice_new_tts_engine");
    void *(*new_message)(void *, const char *, unsigned int, int, const SynthParams *, void *) =
        (void *)GetProcAddress(library, "RHVoice_new_message");
    int (*speak)(void *) = (void *)GetProcAddress(library, "RHVoice_speak");
    void (*delete_message)(void *) = (void *)GetProcAddress(library, "RHVoice_delete_message");
    InitParams init = {.data_path = argv[2], .config_path = argv[3]};
    init.callbacks.set_sample_rate = set_sample_rate;
    init.callbacks.play_speech = play_speech;
    init.callbacks.done = done;
    void *engine = new_engine(&init);
    if (!engine)
        return 4;
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\r\n")] = '\0';
        char *rest = line;
        SynthParams params = {.voice_profile = next_field(&rest), .relative_volume = 1};
        params.relative_rate = atof(next_field(&rest));
        params.relative_pitch = atof(next_field(&rest));
        Output output = {fopen(next_field(&rest), "wb"), 0, 0};
        if (!output.file || !rest)
            return 5;
        void *message = new_message(engine, rest, strlen(rest), 0, &params, &output);
        if (message) {
            speak(message);
            delete_message(message);
        }
        fclose(output.file);
        printf("%lu %d\n", output.count, output.rate);
        fflush(stdout);
    }
    return 0;
}
