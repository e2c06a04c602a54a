// What the shipped components use of Unity, to compile them against.

using System;

namespace UnityEngine
{
    public class Object { public string name; public static implicit operator bool(Object it) => it != null; }
    public class Component : Object { public T GetComponent<T>() => default(T); }
    public class Behaviour : Component { public bool enabled; }
    public class MonoBehaviour : Behaviour { }
    public class AudioClip : Object { }
    public class AudioSource : Behaviour { public AudioClip clip; public bool loop; public void Play() { } }
    public class TextAsset : Object { public byte[] bytes => null; }
    public class Sprite : Object { }
    public class SpriteRenderer : Component { public Sprite sprite; }

    public class Mesh : Object
    {
        public int blendShapeCount => 0;
        public string GetBlendShapeName(int index) => "";
    }

    public class SkinnedMeshRenderer : Component
    {
        public Mesh sharedMesh;
        public void SetBlendShapeWeight(int index, float value) { }
    }

    public static class AudioSettings
    {
        public static int outputSampleRate => 48000;
        public static void GetDSPBufferSize(out int bufferLength, out int numBuffers) { bufferLength = 1024; numBuffers = 4; }
    }

    public static class Microphone
    {
        public static string[] devices => new string[0];
        public static AudioClip Start(string deviceName, bool loop, int lengthSec, int frequency) => null;
    }

    public static class Debug
    {
        public static void LogError(object message, Object context) { }
        public static void LogWarning(object message, Object context) { }
    }

    public sealed class RequireComponent : Attribute { public RequireComponent(Type type) { } }
    public sealed class TooltipAttribute : Attribute { public TooltipAttribute(string words) { } }
    public sealed class RangeAttribute : Attribute { public RangeAttribute(float min, float max) { } }
}
