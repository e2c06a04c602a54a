// Plays Unity's side for the component that moves a face, for tests: PlayUnity.exe PRESET RATE SHAPES, with float32 of a
// microphone on the standard input, which is taken away in the end; without sound there is no microphone.
// Answers are float64 on the standard output: the weights of four blend shapes, at each of 100 pictures a second.

using System;
using System.Collections.Generic;
using System.IO;
using PhonemeEar;
using UnityEngine;

public static class PlayUnity
{
    public static void Main(string[] words)
    {
        var input = new MemoryStream();
        Console.OpenStandardInput().CopyTo(input);
        var sound = new float[input.Length / 4];
        Buffer.BlockCopy(input.ToArray(), 0, sound, 0, 4 * sound.Length);
        var (rate, n) = (int.Parse(words[1]), int.Parse(words[1]) / 100);
        if (sound.Length > 0)
            Microphone.clip = new AudioClip { channels = 1, frequency = rate, samples = rate, content = new float[rate] };
        var mesh = new SkinnedMeshRenderer { name = "Head", sharedMesh = new Mesh { shapes = words[2].Split(',') } };
        var face = new TalkingFace { name = "Actor", microphone = true, faces = new[] { null, mesh } };
        face.preset = new TextAsset { content = File.ReadAllBytes(words[0]) };
        var rows = new List<float>();
        face.Call("OnEnable");
        for (var at = 0; at + n <= sound.Length && face.enabled; at += n)
        {
            Picture(face, mesh, rows);
            Array.Copy(sound, at, Microphone.clip.content, at % rate, n);
            Microphone.position = (at + n) % rate;
        }
        Microphone.isTaken = true;
        for (var k = 0; k < 2 && face.enabled; k++)
            Picture(face, mesh, rows);
        if (Microphone.clip != null && !Microphone.hasEnded)
            Console.Error.WriteLine("the microphone was not closed");
        var output = Console.OpenStandardOutput();
        foreach (double number in rows)
            output.Write(BitConverter.GetBytes(number), 0, 8);
    }

    private static void Picture(TalkingFace face, SkinnedMeshRenderer mesh, List<float> rows)
    {
        face.Call("Update");
        rows.AddRange(mesh.weights);
    }
}
