/* Has ears in C listen to blocks of 10 ms, one after the other, without Python in between. */
#include "ear.h"

enum { HOP = 441, RATE = 44100 };

/* Push n_hops blocks into each of n_ears in turn, as a server would; returns the number of frames that came. */
size_t listen(ear *const *ears, size_t n_ears, const float *samples, size_t n_hops)
{
    ear_frame frames[EAR_MOST_FRAMES(HOP, RATE)];
    size_t hop, k, n, total = 0;
    for (hop = 0; hop < n_hops; hop++)
        for (k = 0; k < n_ears; k++) {
            ear_push(ears[k], samples + HOP * hop, HOP, frames, sizeof frames / sizeof *frames, &n);
            total += n;
        }
    return total;
}
