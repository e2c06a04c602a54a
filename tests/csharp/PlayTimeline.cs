// Plays Unity's Timeline for the clip of exported curves, for tests: PlayTimeline.exe FORMAT RATE NAME, with float32 of one
// curve on the standard input. Answers are float64 on the standard output: how long the clip is, then the weight of the
// blend shape at each third of a value's time, and after the end.

using System;
using System.IO;
using PhonemeEar;
using UnityEngine;
using UnityEngine.Playables;

public static class PlayTimeline
{
    public static void Main(string[] words)
    {
        var input = new MemoryStream();
        Console.OpenStandardInput().CopyTo(input);
        var values = new float[input.Length / 4];
        Buffer.BlockCopy(input.ToArray(), 0, values, 0, (int)input.Length);
        var rate = float.Parse(words[1]);
        JsonUtility.read = new Curves
        {
            format = words[0], rate = rate, duration = values.Length / rate,
            curves = new[] { new Curves.Curve { name = "unknown" }, new Curves.Curve { name = words[2], values = values } }
        };
        var clip = new CurvesClip { curves = new TextAsset { name = "talk" } };
        clip.CreatePlayable(default(PlayableGraph), null);
        var behaviour = ScriptPlayable<CurvesBehaviour>.behaviour;
        var mesh = new SkinnedMeshRenderer { sharedMesh = new Mesh { shapes = new[] { "Smile", "face.jawOpen" } } };
        Write(clip.duration);
        for (var k = 0; k < 3 * values.Length; k++)
        {
            PlayableExtensions.time = k / 3.0 / rate;
            behaviour.ProcessFrame(default(Playable), default(FrameData), mesh);
            Write(mesh.weights[1]);
        }
        behaviour.OnBehaviourPause(default(Playable), default(FrameData));
        Write(mesh.weights[1]);
    }

    private static void Write(double number) => Console.OpenStandardOutput().Write(BitConverter.GetBytes(number), 0, 8);
}
