// Plays Unity's side for the component that moves a face, for tests: PlayUnity.exe PRESET RATE SHAPES, with float32 of a
// microphone on the standard input, which is taken away in the end; without sound there is no microphone. Where a rate
// follows SHAPES, the sound card then goes on at that one, and the same sound comes once more.
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
        var n = int.Parse(words[1]) / 100;
        Microphone.isThere = sound.Length > 0;
        var mesh = new SkinnedMeshRenderer { name = "Head", sharedMesh = new Mesh { shapes = words[2].Split(',') } };
        var face = new TalkingFace { name = "Actor", microphone = true, faces = new[] { null, mesh } };
        face.preset = new TextAsset { content = File.ReadAllBytes(words[0]) };
        var rows = new List<float>();
        face.Call("OnEnable");
        Speak(face, mesh, sound, n, rows);
        if (words.Length > 3)
        {
            AudioSettings.ChangeTo(int.Parse(words[3]));
            if (!Microphone.hasEnded)
                Console.Error.WriteLine("the microphone goes on at the old rate");
            Speak(face, mesh, sound, n, rows);
        }
        Microphone.hasEnded = false;
        Microphone.isTaken = true;
        for (var k = 0; k < 2 && face.enabled; k++)
            Picture(face, mesh, rows);
        if (Microphone.isThere && Microphone.clip != null && !Microphone.hasEnded)
            Console.Error.WriteLine("the microphone was not closed");
        var output = Console.OpenStandardOutput();
        foreach (double number in rows)
            output.Write(BitConverter.GetBytes(number), 0, 8);
    }

    private static void Speak(TalkingFace face, SkinnedMeshRenderer mesh, float[] sound, int n, List<float> rows)
    {
        for (var at = 0; at + n <= sound.Length && face.enabled; at += n)
        {
            Picture(face, mesh, rows);
            if (!face.enabled)
                return;
            Array.Copy(sound, at, Microphone.clip.content, Microphone.position, n);
            Microphone.position = (Microphone.position + n) % Microphone.clip.samples;
        }
    }

    private static void Picture(TalkingFace face, SkinnedMeshRenderer mesh, List<float> rows)
    {
        face.Call("Update");
        rows.AddRange(mesh.weights);
    }
}
