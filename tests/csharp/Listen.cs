// Has the shipped C# listen, for tests: Listen.exe PRESET RATE, with float32 on the standard input.
// Answers are float64 on the standard output: of each frame number, phoneme, viseme, intensity, confidence and scores;
// then, at each of them, the weights of the mouth "arkit", and those by probabilities.

using System;
using System.Collections.Generic;
using System.IO;
using PhonemeEar;

public static class Listen
{
    public static int Main(string[] words)
    {
        try
        {
            Hear(File.ReadAllBytes(words[0]), int.Parse(words[1]));
            return 0;
        }
        catch (EarException error)
        {
            Console.Error.WriteLine(error.Message);
            return 1;
        }
    }

    private static void Hear(byte[] preset, int rate)
    {
        var input = new MemoryStream();
        Console.OpenStandardInput().CopyTo(input);
        var samples = new float[input.Length / 4];
        Buffer.BlockCopy(input.ToArray(), 0, samples, 0, 4 * samples.Length);
        var found = new List<Frame>();
        using (var model = new EarModel(preset))
        using (var ear = new Ear(model, rate))
        using (var mouth = new Mouth(model, model.FindTable("arkit"), 7))
        {
            var block = new float[480];
            var frames = new Frame[ear.MostFrames(block.Length)];
            for (var at = 0; at < samples.Length; at += block.Length)
            {
                var n = Math.Min(block.Length, samples.Length - at);
                Array.Copy(samples, at, block, 0, n);
                Keep(found, frames, ear.Push(block, n, frames));
            }
            Keep(found, frames, ear.Finish(frames));
            using (var output = new BinaryWriter(Console.OpenStandardOutput()))
                Write(output, found, mouth, model);
        }
    }

    private static void Keep(List<Frame> found, Frame[] frames, int n)
    {
        var queue = new FrameQueue();
        queue.Put(frames, n);
        while (queue.TryTake(out var frame))
            found.Add(frame);
    }

    private static void Write(BinaryWriter output, List<Frame> found, Mouth mouth, EarModel model)
    {
        var weights = new float[mouth.Movestates.Count];
        foreach (var frame in found)
        {
            foreach (var number in new double[] { frame.Number, (int)frame.Phoneme, (int)frame.Viseme })
                output.Write(number);
            output.Write((double)frame.Intensity);
            output.Write((double)frame.Confidence);
            foreach (Phoneme phoneme in Enum.GetValues(typeof(Phoneme)))
                output.Write((double)frame.ScoreOf(phoneme));
            for (var viseme = 0; viseme < 32; viseme++)
                output.Write((double)frame.ScoreOf(viseme));
        }
        foreach (var frame in found)
        {
            mouth.Hear(frame.Time, frame);
            mouth.Weights(frame.Time, weights);
            foreach (var weight in weights)
                output.Write((double)weight);
            model.Blend(model.FindTable("arkit"), frame, weights);
            foreach (var weight in weights)
                output.Write((double)weight);
        }
    }
}
