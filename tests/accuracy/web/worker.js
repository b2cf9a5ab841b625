// Runs the experiments beside the page, which stays responsive. A message is {id, call, arguments}; its answer has the same id.
'use strict';
importScripts('lab-engine.js');

const methodTypes = ['string', 'number', 'number', 'number'];  // scene, substeps, integrator, direct joints

const engine = LabEngine();

const calls = {
    scenes: (lab) => JSON.parse(lab.ccall('labScenes', 'string', [], [])),
    measure: (lab, method, seconds) =>
        JSON.parse(lab.ccall('labMeasure', 'string', [...methodTypes, 'number'], [...method, seconds])),
    chart: (lab, scene) => lab.ccall('labChart', 'string', ['string'], [scene]),
    record(lab, method) {
        const scene = JSON.parse(lab.ccall('labRecord', 'string', methodTypes, method));
        const first = lab.ccall('labPoses', 'number', [], []) / 4;
        scene.poses = lab.HEAPF32.slice(first, first + lab.ccall('labPoseCount', 'number', [], []));
        return scene;
    },
};

onmessage = async ({ data }) => {
    try {
        postMessage({ id: data.id, result: calls[data.call](await engine, ...data.arguments) });
    } catch (error) {
        postMessage({ id: data.id, error: String(error) });
    }
};
