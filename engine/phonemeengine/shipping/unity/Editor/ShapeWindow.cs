// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace PhonemeEar
{
    /// <summary>Assigns blend shapes to the movestates of a Talking Face, and bakes exported curves into a clip.</summary>
    public sealed class ShapeWindow : EditorWindow
    {
        private const string NoShape = "(none)";
        private const string NamesFile = "Packages/com.phonemeanalyser.ear/Editor/shape_names.txt";

        private TalkingFace face;
        private TextAsset curves;
        private Vector2 scroll;
        private string trouble = "";
        private ShapeGuess guess;
        private TextAsset shown; // the preset whose movestates are listed
        private string[] movestates = new string[0];

        [MenuItem("Window/Phoneme Ear")]
        private static void Open() => GetWindow<ShapeWindow>("Phoneme Ear");

        private void OnEnable()
        {
            var found = AssetDatabase.FindAssets("shape_names t:TextAsset").Select(AssetDatabase.GUIDToAssetPath);
            var path = found.FirstOrDefault(one => one.EndsWith("Editor/shape_names.txt", StringComparison.Ordinal)) ?? NamesFile;
            var names = AssetDatabase.LoadAssetAtPath<TextAsset>(path);
            guess = new ShapeGuess(names ? names.text : "");
        }

        private void OnGUI()
        {
            face = (TalkingFace)EditorGUILayout.ObjectField("Talking Face", face, typeof(TalkingFace), true);
            if (trouble != "")
                EditorGUILayout.HelpBox(trouble, MessageType.Warning);
            var names = face ? ShapesOf(face) : new string[0];
            if (names.Length == 0)
            {
                EditorGUILayout.HelpBox("Choose a Talking Face whose Faces are meshes with blend shapes.", MessageType.Info);
                return;
            }
            ShowShapes(names);
            ShowBake();
        }

        private void ShowShapes(string[] names)
        {
            Try(ReadMovestates);
            var assigned = face.shapes.GroupBy(shape => shape.movestate).ToDictionary(one => one.Key, one => one.Last().blendShape);
            if (GUILayout.Button("Guess all"))
                Assign(movestates.ToDictionary(state => state, state => guess.For(state, names)));
            scroll = EditorGUILayout.BeginScrollView(scroll);
            var choices = new[] { NoShape }.Concat(names).ToArray();
            foreach (var movestate in movestates)
            {
                var now = assigned.TryGetValue(movestate, out var name) ? name : names.FirstOrDefault(one => one == movestate) ?? "";
                var chosen = EditorGUILayout.Popup(movestate, Math.Max(0, Array.IndexOf(choices, now)), choices);
                if (choices[chosen] == (now == "" ? NoShape : now))
                    continue;
                assigned[movestate] = chosen == 0 ? "" : choices[chosen];
                Assign(assigned);
            }
            EditorGUILayout.EndScrollView();
        }

        private void ShowBake()
        {
            curves = (TextAsset)EditorGUILayout.ObjectField("Curves (curves-json)", curves, typeof(TextAsset), false);
            if (curves && GUILayout.Button("Bake into an animation clip…"))
                Try(Bake);
        }

        private void ReadMovestates()
        {
            if (face.preset == shown)
                return;
            shown = face.preset;
            movestates = new string[0];
            if (!shown)
                return;
            using (var model = new EarModel(shown.bytes))
                movestates = model.Movestates(model.FindTable(string.IsNullOrEmpty(face.table) ? "arkit" : face.table)).ToArray();
        }

        private void Assign(Dictionary<string, string> shapes)
        {
            Undo.RecordObject(face, "Assign Shapes");
            face.shapes = shapes.Select(one => new TalkingFace.AssignedShape { movestate = one.Key, blendShape = one.Value }).ToArray();
            EditorUtility.SetDirty(face);
        }

        private void Bake()
        {
            var read = Curves.Read(curves.text);
            var clip = new AnimationClip { frameRate = read.rate };
            foreach (var mesh in face.faces.Where(one => one && one.sharedMesh))
                foreach (var curve in read.curves)
                {
                    var target = TalkingFace.TargetOf(mesh.sharedMesh, curve.name, face.shapes);
                    if (target >= 0)
                        AnimationUtility.SetEditorCurve(clip, BindingOf(mesh, target), KeysOf(read, curve));
                }
            var path = EditorUtility.SaveFilePanelInProject("Bake", curves.name, "anim", "Where the clip is saved");
            if (path != "")
                AssetDatabase.CreateAsset(clip, path);
        }

        private EditorCurveBinding BindingOf(SkinnedMeshRenderer mesh, int target) =>
            EditorCurveBinding.FloatCurve(
                AnimationUtility.CalculateTransformPath(mesh.transform, face.transform.root),
                typeof(SkinnedMeshRenderer),
                "blendShape." + mesh.sharedMesh.GetBlendShapeName(target));

        private AnimationCurve KeysOf(Curves read, Curves.Curve curve) =>
            new AnimationCurve(curve.values.Select((value, k) => new Keyframe(k / read.rate, face.strength * value)).ToArray());

        private void Try(Action act)
        {
            try
            {
                act();
                trouble = "";
            }
            catch (EarException error)
            {
                trouble = error.Message;
            }
        }

        private static string[] ShapesOf(TalkingFace face) =>
            face.faces.Where(one => one && one.sharedMesh)
                .SelectMany(one => Enumerable.Range(0, one.sharedMesh.blendShapeCount).Select(one.sharedMesh.GetBlendShapeName))
                .Distinct().ToArray();
    }
}
