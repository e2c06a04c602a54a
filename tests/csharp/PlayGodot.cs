// Plays Godot's side for the node that moves a face, for tests: PlayGodot.exe PRESET RATE SHAPES, with float32 on the
// standard input, of a bus that is silent afterwards; without sound there is no bus.
// Answers are float64 on the standard output: the weights of four blend shapes, at each of 100 pictures a second.

using System;
using System.IO;
using Godot;
using PhonemeEar;

public static class PlayGodot
{
    public static void Main(string[] words)
    {
        var input = new MemoryStream();
        Console.OpenStandardInput().CopyTo(input);
        var sound = new float[input.Length / 4 + 44100];
        Buffer.BlockCopy(input.ToArray(), 0, sound, 0, (int)input.Length);
        AudioServer.Capture = input.Length > 0 ? new AudioEffectCapture() : null;
        var mesh = new MeshInstance3D { Name = "Head", Shapes = words[2].Split(',') };
        var face = new TalkingFace { Name = "Actor", Preset = words[0], Face = mesh };
        var (n, output) = (int.Parse(words[1]) / 100, Console.OpenStandardOutput());
        face._Ready();
        for (var at = 0; at + n <= sound.Length && face.IsProcessing; at += n)
        {
            AudioServer.Capture.Waiting = new Vector2[n];
            for (var k = 0; k < n; k++)
                AudioServer.Capture.Waiting[k] = new Vector2 { X = 2 * sound[at + k] };
            face._Process(0.01);
            foreach (double number in mesh.Weights)
                output.Write(BitConverter.GetBytes(number), 0, 8);
        }
        face._ExitTree();
    }
}
