// SPDX-License-Identifier: MIT
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.Timeline;

namespace PhonemeEar
{
    /// <summary>A clip of the Timeline that moves a mesh by exported curves.</summary>
    public sealed class CurvesClip : PlayableAsset, ITimelineClipAsset
    {
        [Tooltip("A file that was exported as curves-json, with the ending .json")]
        public TextAsset curves;

        [Tooltip("Weight of a whole movement")]
        public float strength = 100;

        public ClipCaps clipCaps => ClipCaps.ClipIn | ClipCaps.SpeedMultiplier;

        private TextAsset shown;
        private Curves read = new Curves();

        public override double duration => curves ? Read().duration : base.duration;

        public override Playable CreatePlayable(PlayableGraph graph, GameObject owner)
        {
            var playable = ScriptPlayable<CurvesBehaviour>.Create(graph);
            var behaviour = playable.GetBehaviour();
            behaviour.Curves = Read();
            behaviour.Strength = strength;
            return playable;
        }

        /// <summary>Read the file once; one that cannot be used moves nothing.</summary>
        private Curves Read()
        {
            if (curves == shown)
                return read;
            shown = curves;
            read = new Curves();
            try
            {
                if (curves)
                    read = Curves.Read(curves.text);
            }
            catch (EarException error)
            {
                Debug.LogError($"{curves.name}: {error.Message}", this);
            }
            return read;
        }
    }
}
