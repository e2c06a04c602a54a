// SPDX-License-Identifier: MIT
// Recognises phonemes and visemes in speech, every 10 ms, and moves a mouth by them: the functions of ear.h.
//
// Any number of recognisers (`Ear`) share a model, each on a thread of its own. A recogniser, and a mouth, belongs to one
// thread at a time. Push and Weights allocate nothing, so the audio thread may call them. An object that was disposed
// of, or whose model was, throws an ObjectDisposedException.

using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace PhonemeEar
{
    /// <summary>What a frame can be.</summary>
    public enum Phoneme { Silence, Unidentified, Sz, Sch, M, P, I, A, E, U, O }

    /// <summary>What lips and tongue show; None where it is unknown.</summary>
    public enum Viseme { Sil, PP, FF, TH, DD, KK, CH, SS, NN, RR, AA, E, IH, OH, OU, None = 255 }

    /// <summary>What cannot be done, in a sentence.</summary>
    public sealed class EarException : Exception
    {
        public EarException(string message) : base(message) { }
    }

#pragma warning disable 0649 // the library writes these
    /// <summary>What was recognised in 10 ms.</summary>
    [StructLayout(LayoutKind.Sequential, Size = Bytes)]
    public struct Frame
    {
        /// <summary>It lasts from Number x 10 ms of the sound to 10 ms later.</summary>
        public readonly uint Number;
        internal const int Bytes = 192;
        public readonly Phoneme Phoneme;
        public readonly Viseme Viseme;
        /// <summary>How loud, 0..1.</summary>
        public readonly float Intensity;
        /// <summary>The share of such answers that are right, 0..1; NaN where the preset has no such curve.</summary>
        public readonly float Confidence;
        private readonly float silence, unidentified, sz, sch, m, p, i, a, e, u, o;

        /// <summary>Seconds.</summary>
        public double Time => Number / 100.0;

        /// <summary>How likely a viseme is, by its number; 0 where the preset tells none apart.</summary>
        public float ScoreOf(int viseme)
        {
            if (viseme < 0 || viseme >= 32)
                throw new EarException($"there is no viseme {viseme}; ask for one of 0..31");
            var frame = this;
            return Native.ear_frame_viseme_score(ref frame, viseme);
        }

        /// <summary>How likely a viseme is; 0 where the preset tells none apart.</summary>
        public float ScoreOf(Viseme viseme) => ScoreOf((int)viseme);

        /// <summary>How likely a phoneme is; 0 with rules, which name one only.</summary>
        public float ScoreOf(Phoneme phoneme)
        {
            switch (phoneme)
            {
                case Phoneme.Silence: return silence;
                case Phoneme.Unidentified: return unidentified;
                case Phoneme.Sz: return sz;
                case Phoneme.Sch: return sch;
                case Phoneme.M: return m;
                case Phoneme.P: return p;
                case Phoneme.I: return i;
                case Phoneme.A: return a;
                case Phoneme.E: return e;
                case Phoneme.U: return u;
                default: return o;
            }
        }
    }
#pragma warning restore 0649

    /// <summary>A preset, and what it knows.</summary>
    public sealed class EarModel : IDisposable
    {
        private IntPtr handle;

        internal IntPtr Handle => Native.Open(handle, nameof(EarModel));

        /// <summary>Open the bytes of an .ear file; they are not needed afterwards.</summary>
        public EarModel(byte[] preset)
        {
            Native.CheckLibrary();
            Native.Check(Native.ear_model_open(preset, (UIntPtr)preset.Length, IntPtr.Zero, UIntPtr.Zero, out handle));
        }

        public string Name => Native.Text(Native.ear_model_name(Handle));

        /// <summary>For how long it waits before it says what a frame is, seconds.</summary>
        public double LookAhead => Native.ear_model_look_ahead(Handle) / 100.0;

        /// <summary>The number of a mouth table, such as "arkit".</summary>
        public int FindTable(string name)
        {
            var number = Native.ear_table_find(Handle, Encoding.UTF8.GetBytes(name + "\0"));
            if (number < 0)
                throw new EarException($"the preset has no mouth table {name}; ship it with --table {name}, or choose another");
            return number;
        }

        /// <summary>The names of the visemes that the preset tells apart: those of Viseme, or its own.</summary>
        public IReadOnlyList<string> Visemes()
        {
            var names = new string[Native.ear_model_visemes(Handle)];
            for (var k = 0; k < names.Length; k++)
                names[k] = Native.Text(Native.ear_model_viseme(Handle, k));
            return names;
        }

        /// <summary>The blend shapes that a table moves, in the order of all weights.</summary>
        public IReadOnlyList<string> Movestates(int table)
        {
            var names = new string[Native.ear_table_movestates(Handle, table)];
            for (var k = 0; k < names.Length; k++)
                names[k] = Native.Text(Native.ear_table_movestate(Handle, table, k));
            return names;
        }

        /// <summary>The names of the shapes of a table, such as "B": for drawings.</summary>
        public IReadOnlyList<string> Shapes(int table)
        {
            var names = new string[Native.ear_table_shapes(Handle, table)];
            for (var k = 0; k < names.Length; k++)
                names[k] = Native.Text(Native.ear_table_shape_name(Handle, table, k));
            return names;
        }

        /// <summary>Which of a table's shapes goes with a frame.</summary>
        public int ShapeOf(int table, in Frame frame) =>
            Native.ear_table_shape(Handle, table, (int)frame.Phoneme, (int)frame.Viseme);

        /// <summary>
        /// Put the weights of a table's movestates for a frame into `weights`: all visemes, each by how likely it is. They
        /// are continuous and not smoothed; a Mouth moves smoothly.
        /// </summary>
        public void Blend(int table, in Frame frame, float[] weights)
        {
            var n = Native.ear_table_movestates(Handle, table);
            if (weights.Length < n)
                throw new EarException($"a table of {n} movestates needs as much room, got {weights.Length}");
            var copy = frame;
            Native.Check(Native.ear_table_blend(Handle, table, ref copy, weights));
        }

        public void Dispose()
        {
            Native.ear_model_close(handle);
            handle = IntPtr.Zero;
        }
    }

    /// <summary>Recognises one stream of sound, mono, +-1, at any rate of 1..768 kHz.</summary>
    public sealed class Ear : IDisposable
    {
        private IntPtr handle;
        private readonly EarModel model;
        private readonly int rate;

        private IntPtr Handle => Native.Open(handle, model, nameof(Ear));

        public Ear(EarModel model, int rate)
        {
            this.model = model;
            this.rate = rate;
            Native.Check(Native.ear_open_sized(
                model.Handle, (uint)Math.Max(0, rate), (UIntPtr)Frame.Bytes, IntPtr.Zero, UIntPtr.Zero, out handle));
        }

        /// <summary>From the middle of a frame to when it is known: the mean, seconds.</summary>
        public double Latency => Native.ear_latency(Handle);

        /// <summary>At least as many frames as come of n samples at once, and as Finish gives.</summary>
        public int MostFrames(int n)
        {
            Native.Open(handle, model, nameof(Ear));
            return Math.Max(32, (int)((long)n * 100 / rate) + 2);
        }

        /// <summary>Take the first n samples, put the frames that became known into `frames`, and return their number.</summary>
        public int Push(float[] samples, int n, Frame[] frames)
        {
            if (n > samples.Length)
                throw new EarException($"{n} samples were promised, and there are {samples.Length}; hand in fewer");
            Native.Check(Native.ear_push(Handle, samples, (UIntPtr)n, frames, (UIntPtr)frames.Length, out var count));
            return (int)count;
        }

        /// <summary>The sound is over: give its last frames, at most 32. Then the recogniser is as new.</summary>
        public int Finish(Frame[] frames)
        {
            Native.Check(Native.ear_finish(Handle, frames, (UIntPtr)frames.Length, out var count));
            return (int)count;
        }

        /// <summary>Forget the sound, and begin another one.</summary>
        public void Reset() => Native.ear_reset(Handle);

        public void Dispose()
        {
            Native.ear_close(handle);
            handle = IntPtr.Zero;
        }
    }

    /// <summary>Moves smoothly from shape to shape; equal seeds make equal mouths.</summary>
    public sealed class Mouth : IDisposable
    {
        private IntPtr handle;
        private readonly EarModel model;
        private readonly IReadOnlyList<string> movestates;

        private IntPtr Handle => Native.Open(handle, model, nameof(Mouth));

        /// <summary>The blend shapes that it moves, in the order of all weights.</summary>
        public IReadOnlyList<string> Movestates
        {
            get
            {
                Native.Open(handle, model, nameof(Mouth));
                return movestates;
            }
        }

        public Mouth(EarModel model, int table, int seed = 1)
        {
            this.model = model;
            movestates = model.Movestates(table);
            Native.Check(Native.ear_mouth_open(model.Handle, table, (uint)seed, IntPtr.Zero, UIntPtr.Zero, out handle));
        }

        /// <summary>Take a frame that holds from a time on, seconds of a clock of yours, which never goes back.</summary>
        public void Hear(double time, in Frame frame) =>
            Native.ear_mouth_hear(Handle, time, (int)frame.Phoneme, (int)frame.Viseme, frame.Intensity);

        /// <summary>Put the weights of its movestates at a time, 0..1, into `weights`; times never go back.</summary>
        public void Weights(double time, float[] weights)
        {
            if (weights.Length < Movestates.Count)
                throw new EarException($"a mouth of {Movestates.Count} movestates needs as much room, got {weights.Length}");
            Native.ear_mouth_weights(Handle, time, weights);
        }

        public void Dispose()
        {
            Native.ear_mouth_close(handle);
            handle = IntPtr.Zero;
        }
    }

    internal static class Native
    {
#if !UNITY_EDITOR && (UNITY_WEBGL || UNITY_IOS || (UNITY_ANDROID && ENABLE_IL2CPP))
        internal const string Library = "__Internal"; // compiled into the program
#else
        internal const string Library = "ear";
#endif
        private const string CodeVersion = "0.9.0";

        internal static void Check(int code)
        {
            if (code != 0)
                throw new EarException(Text(ear_error_text(code)));
        }

        /// <summary>Return a handle, unless its memory was given back, which the library would read nevertheless.</summary>
        internal static IntPtr Open(IntPtr handle, string name) =>
            handle != IntPtr.Zero ? handle : throw new ObjectDisposedException(name);

        /// <summary>Return the handle of what reads the memory of a model, unless either was given back.</summary>
        internal static IntPtr Open(IntPtr handle, EarModel model, string name)
        {
            Open(model.Handle, nameof(EarModel));
            return Open(handle, name);
        }

        internal static string Text(IntPtr start)
        {
            var n = 0;
            while (Marshal.ReadByte(start, n) != 0)
                n++;
            var bytes = new byte[n];
            Marshal.Copy(start, bytes, 0, n);
            return Encoding.UTF8.GetString(bytes);
        }

        /// <summary>Refuse a library that is not there, or is older than this code; a newer one knows all that it calls.</summary>
        internal static void CheckLibrary()
        {
            try
            {
                var found = Text(ear_version());
                if (new Version(found) < new Version(CodeVersion))
                    throw new EarException($"the library {Library} has the version {found}, this code {CodeVersion}; take both from one package");
            }
            catch (Exception error) when (error is TypeLoadException || error is BadImageFormatException) // not there, other one
            {
                throw new EarException($"the library {Library} cannot be used ({error.Message}); take it from the package of this code");
            }
        }

        [DllImport(Library)] private static extern IntPtr ear_version();
        [DllImport(Library)] internal static extern IntPtr ear_error_text(int code);
        [DllImport(Library)]
        internal static extern int ear_model_open(byte[] bytes, UIntPtr n, IntPtr memory, UIntPtr size, out IntPtr model);
        [DllImport(Library)] internal static extern void ear_model_close(IntPtr model);
        [DllImport(Library)] internal static extern IntPtr ear_model_name(IntPtr model);
        [DllImport(Library)] internal static extern int ear_model_look_ahead(IntPtr model);
        [DllImport(Library)] internal static extern int ear_model_visemes(IntPtr model);
        [DllImport(Library)] internal static extern IntPtr ear_model_viseme(IntPtr model, int viseme);
        [DllImport(Library)]
        internal static extern int ear_open_sized(
            IntPtr model, uint rate, UIntPtr frameSize, IntPtr memory, UIntPtr size, out IntPtr listener);
        [DllImport(Library)] internal static extern float ear_frame_viseme_score(ref Frame frame, int viseme);
        [DllImport(Library)]
        internal static extern int ear_table_blend(IntPtr model, int table, ref Frame frame, [Out] float[] weights);
        [DllImport(Library)] internal static extern void ear_close(IntPtr listener);
        [DllImport(Library)]
        internal static extern int ear_push(
            IntPtr listener, [In] float[] samples, UIntPtr n, [Out] Frame[] frames, UIntPtr most, out UIntPtr count);
        [DllImport(Library)]
        internal static extern int ear_finish(IntPtr listener, [Out] Frame[] frames, UIntPtr most, out UIntPtr count);
        [DllImport(Library)] internal static extern void ear_reset(IntPtr listener);
        [DllImport(Library)] internal static extern double ear_latency(IntPtr listener);
        [DllImport(Library)] internal static extern int ear_table_find(IntPtr model, byte[] name);
        [DllImport(Library)] internal static extern int ear_table_movestates(IntPtr model, int table);
        [DllImport(Library)] internal static extern IntPtr ear_table_movestate(IntPtr model, int table, int movestate);
        [DllImport(Library)] internal static extern int ear_table_shapes(IntPtr model, int table);
        [DllImport(Library)] internal static extern int ear_table_shape(IntPtr model, int table, int phoneme, int viseme);
        [DllImport(Library)] internal static extern IntPtr ear_table_shape_name(IntPtr model, int table, int shape);
        [DllImport(Library)]
        internal static extern int ear_mouth_open(
            IntPtr model, int table, uint seed, IntPtr memory, UIntPtr size, out IntPtr mouth);
        [DllImport(Library)] internal static extern void ear_mouth_close(IntPtr mouth);
        [DllImport(Library)]
        internal static extern void ear_mouth_hear(IntPtr mouth, double time, int phoneme, int viseme, float intensity);
        [DllImport(Library)] internal static extern void ear_mouth_weights(IntPtr mouth, double time, [Out] float[] weights);
    }
}
