// SPDX-License-Identifier: MIT
using UnityEngine;
using UnityEngine.Timeline;

namespace PhonemeEar
{
    /// <summary>A track of the Timeline for a mesh, with clips of exported curves.</summary>
    [TrackClipType(typeof(CurvesClip)), TrackBindingType(typeof(SkinnedMeshRenderer))]
    public sealed class CurvesTrack : TrackAsset { }
}
