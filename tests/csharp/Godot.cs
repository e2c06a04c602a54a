// What the shipped nodes use of Godot, and of .NET where Mono lacks it, to compile them against; and as much at
// work as PlayGodot.cs needs.

using System;
using System.Reflection;

namespace Godot
{
    public enum PropertyHint { File }

    public sealed class ExportAttribute : Attribute
    {
        public ExportAttribute(PropertyHint hint = PropertyHint.File, string words = "") { }
    }

    public sealed class GlobalClassAttribute : Attribute { }
    public struct Vector2 { public float X, Y; }
    public class GodotObject { }

    public class Node : GodotObject
    {
        public string Name = "";
        public bool IsProcessing = true;
        public void SetProcess(bool enable) => IsProcessing = enable;
        public virtual void _Ready() { }
        public virtual void _ExitTree() { }
        public virtual void _Process(double delta) { }
    }

    public class MeshInstance3D : Node
    {
        public string[] Shapes = new string[0];
        public readonly float[] Weights = new float[4];
        public int FindBlendShapeByName(string name) => Array.IndexOf(Shapes, name);
        public void SetBlendShapeValue(int index, float value) => Weights[index] = value;
    }

    public class SpriteFrames : GodotObject { public bool HasAnimation(string name) => false; }
    public class AnimatedSprite2D : Node { public SpriteFrames SpriteFrames = null; public string Animation; }
    public class AudioEffect : GodotObject { }

    public class AudioEffectCapture : AudioEffect
    {
        public Vector2[] Waiting = new Vector2[0];
        public int GetFramesAvailable() => Waiting.Length;
        public Vector2[] GetBuffer(int frames) => Waiting;
    }

    public static class AudioServer
    {
        public static AudioEffectCapture Capture; // of the only bus
        public static int GetBusIndex(string name) => name == "Voice" ? 0 : -1;
        public static int GetBusEffectCount(int bus) => 1;
        public static AudioEffect GetBusEffect(int bus, int effect) => Capture;
        public static float GetMixRate() => 44100;
    }

    public static class FileAccess { public static byte[] GetFileAsBytes(string path) => System.IO.File.ReadAllBytes(path); }
    public static class Mathf { public static int Min(int a, int b) => Math.Min(a, b); }
    public static class OS { public static string GetName() => ""; public static string GetExecutablePath() => ""; }
    public static class ProjectSettings { public static string GlobalizePath(string path) => path; }
    public static class GD
    {
        public static void PushError(string words) => Console.Error.WriteLine($"Error: {words}");
        public static void PushWarning(string words) => Console.Error.WriteLine($"Warning: {words}");
    }
}

namespace System.Runtime.InteropServices
{
    public delegate IntPtr DllImportResolver(string name, Assembly assembly, DllImportSearchPath? path);

    public static class NativeLibrary
    {
        public static void SetDllImportResolver(Assembly assembly, DllImportResolver resolver) { }
        public static bool TryLoad(string path, out IntPtr handle) { handle = IntPtr.Zero; return false; }
    }
}
