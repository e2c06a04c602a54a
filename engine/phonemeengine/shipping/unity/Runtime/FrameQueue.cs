// SPDX-License-Identifier: MIT
using System.Threading;

namespace PhonemeEar
{
    /// <summary>Hands frames from one thread, which puts, to another one, which takes. Neither waits or allocates.</summary>
    public sealed class FrameQueue
    {
        private readonly Frame[] ring = new Frame[256];
        private int put, taken;

        /// <summary>Add frames. A full queue, from which none were taken for seconds, drops them.</summary>
        public void Put(Frame[] frames, int n)
        {
            var room = ring.Length - (put - Volatile.Read(ref taken));
            for (var k = 0; k < n && k < room; k++)
                ring[(put + k) & (ring.Length - 1)] = frames[k];
            Volatile.Write(ref put, put + (n < room ? n : room));
        }

        /// <summary>Take the oldest frame; false where there is none.</summary>
        public bool TryTake(out Frame frame)
        {
            frame = ring[taken & (ring.Length - 1)];
            if (taken == Volatile.Read(ref put))
                return false;
            Volatile.Write(ref taken, taken + 1);
            return true;
        }
    }
}
