// What the shipped components use of Unity, to compile them against; and as much at work as PlayUnity.cs needs.

using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine
{
    public class Object { public string name; public static implicit operator bool(Object it) => it != null; }
    public class Component : Object
    {
        public T GetComponent<T>() => default(T);
        public T[] GetComponentsInChildren<T>() => new T[0];
        public Transform transform;
        public GameObject gameObject;
    }
    public class Transform : Component { public Transform root; }
    public class GameObject : Object { public T AddComponent<T>() where T : Component => default(T); }
    public class Behaviour : Component
    {
        private bool isEnabled = true;
        public bool enabled
        {
            get => isEnabled;
            set
            {
                if (isEnabled && !value)
                    Call("OnDisable");
                isEnabled = value;
            }
        }

        public void Call(string name)
        {
            for (var type = GetType(); type != null; type = type.BaseType)
            {
                var found = type.GetMethod(name, BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.DeclaredOnly);
                if (found == null)
                    continue;
                found.Invoke(this, null);
                return;
            }
        }
    }

    public class MonoBehaviour : Behaviour { }
    public class ScriptableObject : Object { }
    public class AudioClip : Object
    {
        public int channels, frequency, samples;
        public float[] content;
        public bool GetData(float[] data, int offsetSamples)
        {
            for (var k = 0; k < data.Length; k++)
                data[k] = content[(offsetSamples + k) % samples];
            return true;
        }
    }
    public class AudioSource : Behaviour { public AudioClip clip; public int timeSamples; }
    public class TextAsset : Object { public byte[] content; public byte[] bytes => content; public string text => ""; }
    public class Sprite : Object { }
    public class SpriteRenderer : Component { public Sprite sprite; }
    public struct Vector2 { }
    public struct Keyframe { public Keyframe(float time, float value) { } }
    public class AnimationCurve { public AnimationCurve(params Keyframe[] keys) { } }
    public class AnimationClip : Object { public float frameRate { get; set; } }

    public class Mesh : Object
    {
        public string[] shapes = new string[0];
        public int blendShapeCount => shapes.Length;
        public string GetBlendShapeName(int shapeIndex) => shapes[shapeIndex];
    }

    public class SkinnedMeshRenderer : Component
    {
        public Mesh sharedMesh;
        public readonly float[] weights = new float[4];
        public void SetBlendShapeWeight(int index, float value) => weights[index] = value;
    }

    public static class AudioSettings
    {
        public delegate void AudioConfigurationChangeHandler(bool deviceWasChanged);
        public static event AudioConfigurationChangeHandler OnAudioConfigurationChanged { add { } remove { } }
        public static int outputSampleRate => 44100;
        public static void GetDSPBufferSize(out int bufferLength, out int numBuffers) { bufferLength = 1024; numBuffers = 4; }
    }

    public static class Microphone
    {
        public static AudioClip clip; // of the only one there is; null without one
        public static bool isTaken, hasEnded;
        public static int position;
        public static string[] devices => clip == null ? new string[0] : new[] { "one" };
        public static AudioClip Start(string deviceName, bool loop, int lengthSec, int frequency) => clip;
        public static void End(string deviceName) => hasEnded = true;
        public static bool IsRecording(string deviceName) => !isTaken;
        public static int GetPosition(string deviceName) => position;
    }

    public static class JsonUtility { public static T FromJson<T>(string json) => (T)read; public static object read; }
    public static class GUILayout { public static bool Button(string text) => false; }

    public static class Debug
    {
        public static void LogError(object message, Object context) => Console.Error.WriteLine($"Error: {message}");
        public static void LogWarning(object message, Object context) => Console.Error.WriteLine($"Warning: {message}");
    }

    public sealed class RequireComponent : Attribute { public RequireComponent(Type type) { } }
    public sealed class AddComponentMenu : Attribute { public AddComponentMenu(string menuName) { } }
    public sealed class TooltipAttribute : Attribute { public TooltipAttribute(string words) { } }
    public sealed class RangeAttribute : Attribute { public RangeAttribute(float min, float max) { } }
}

namespace UnityEngine.Playables
{
    public struct PlayableGraph { }
    public struct FrameData { public float weight => 1; }
    public interface IPlayable { }
    public interface IPlayableBehaviour { }
    public struct Playable : IPlayable { }
    public static class PlayableExtensions { public static double GetTime<U>(this U playable) where U : struct, IPlayable => time; public static double time; }

    public struct ScriptPlayable<T> : IPlayable where T : class, IPlayableBehaviour, new()
    {
        public static ScriptPlayable<T> Create(PlayableGraph graph, int inputCount = 0) => default(ScriptPlayable<T>);
        public static T behaviour;
        public T GetBehaviour() => behaviour = new T();
        public static implicit operator Playable(ScriptPlayable<T> it) => default(Playable);
    }

    public abstract class PlayableBehaviour : IPlayableBehaviour
    {
        public virtual void ProcessFrame(Playable playable, FrameData info, object playerData) { }
        public virtual void OnBehaviourPause(Playable playable, FrameData info) { }
    }

    public abstract class PlayableAsset : ScriptableObject
    {
        public virtual double duration => 0;
        public abstract Playable CreatePlayable(PlayableGraph graph, GameObject owner);
    }
}

namespace UnityEngine.Timeline
{
    [Flags] public enum ClipCaps { None = 0, ClipIn = 2, SpeedMultiplier = 4 }
    public interface ITimelineClipAsset { ClipCaps clipCaps { get; } }
    public abstract class TrackAsset : ScriptableObject { }
    public sealed class TrackClipTypeAttribute : Attribute { public TrackClipTypeAttribute(Type clipClass) { } }
    public sealed class TrackBindingTypeAttribute : Attribute { public TrackBindingTypeAttribute(Type type) { } }
}

namespace UnityEditor
{
    using UnityEngine;

    public enum MessageType { None, Info, Warning, Error }
    public sealed class MenuItem : Attribute { public MenuItem(string itemName) { } }
    public class EditorWindow : ScriptableObject { public static T GetWindow<T>(string title) where T : EditorWindow => null; }

    public static class AssetDatabase
    {
        public static string[] FindAssets(string filter) => new string[0];
        public static string GUIDToAssetPath(string guid) => "";
        public static T LoadAssetAtPath<T>(string assetPath) where T : Object => null;
        public static void CreateAsset(Object asset, string path) { }
    }

    public static class EditorGUILayout
    {
        public static Object ObjectField(string label, Object obj, Type objType, bool allowSceneObjects) => obj;
        public static void HelpBox(string message, MessageType type) { }
        public static Vector2 BeginScrollView(Vector2 scrollPosition) => scrollPosition;
        public static void EndScrollView() { }
        public static int Popup(string label, int selectedIndex, string[] displayedOptions) => selectedIndex;
    }

    public static class EditorUtility
    {
        public static void SetDirty(Object target) { }
        public static string SaveFilePanelInProject(string title, string defaultName, string extension, string message) => "";
    }

    public static class Undo { public static void RecordObject(Object objectToUndo, string name) { } }
    public struct EditorCurveBinding
    {
        public static EditorCurveBinding FloatCurve(string inPath, Type inType, string inPropertyName) => default(EditorCurveBinding);
    }

    public static class AnimationUtility
    {
        public static void SetEditorCurve(AnimationClip clip, EditorCurveBinding binding, AnimationCurve curve) { }
        public static string CalculateTransformPath(Transform targetTransform, Transform root) => "";
    }
}
