/* Has ears in C listen to blocks of 10 ms, one after the other, without Python in between. */
#include "ear.h"

enum { MOST = EAR_MOST_FRAMES(1, 100) }; /* of 10 ms at any rate */

/* Push n_hops blocks of `hop` samples into each of n_ears in turn, as a server would; returns the number of frames that came. */
size_t listen(ear *const *ears, size_t n_ears, const float *samples, size_t hop, size_t n_hops)
{
    ear_frame frames[MOST];
    size_t at, k, n, total = 0;
    for (at = 0; at < n_hops; at++)
        for (k = 0; k < n_ears; k++) {
            ear_push(ears[k], samples + hop * at, hop, frames, sizeof frames / sizeof *frames, &n);
            total += n;
        }
    return total;
}
