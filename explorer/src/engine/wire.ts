// Messages between the engine and its workers.
import type {
  CaseInfo,
  ChosenColumn,
  Edit,
  Layout,
  MeasuredColumn,
  MeasuredSpectrumRequest,
  MeasuredTable,
  MotionResult,
  OrbitRequest,
  PointRequest,
  PointResult,
  Problem,
  RunRequest,
  RunResult,
  Setting,
  TransientRequest,
  TransientResult,
  Verdict,
} from './protocol';

/// Some points of a sweep, computed by one worker.
export interface PartRequest {
  readonly setting: Setting;
  readonly parameter: string;
  readonly batch?: string | undefined;
  readonly values: Float64Array;
  /// True if each point starts from the end of the one before.
  readonly carried: boolean;
  /// True to compute fields of spectra too.
  readonly spectra: boolean;
}

export type Task =
  | { readonly kind: 'describe'; readonly setting: Setting }
  | { readonly kind: 'point'; readonly request: PointRequest }
  | { readonly kind: 'orbit'; readonly request: OrbitRequest }
  | { readonly kind: 'part'; readonly request: PartRequest }
  | { readonly kind: 'transient'; readonly request: TransientRequest }
  | { readonly kind: 'run'; readonly request: RunRequest }
  | {
      readonly kind: 'measured';
      readonly setting: Setting;
      readonly name: string;
      readonly bytes: Uint8Array;
      readonly columns: readonly ChosenColumn[];
    }
  | { readonly kind: 'measured-columns'; readonly name: string; readonly bytes: Uint8Array }
  | { readonly kind: 'measured-spectrum'; readonly request: MeasuredSpectrumRequest }
  | { readonly kind: 'rewrite'; readonly setting: Setting; readonly edits: readonly Edit[] };

export type ToWorker =
  | { readonly kind: 'start'; readonly core: Uint8Array }
  | { readonly kind: 'task'; readonly id: number; readonly priority: number; readonly task: Task }
  | { readonly kind: 'stop'; readonly id: number };

/// Finished points of a part; `indices` are indices of the part's values.
export interface PartPoints {
  readonly indices: Uint32Array;
  readonly blocks: Float64Array;
  readonly verdicts: readonly Verdict[];
  readonly lengthScales: Float64Array;
}

export interface PartLayout {
  readonly layout: Layout;
  readonly revolutions: number;
}

export interface Refusal {
  readonly message: string;
  readonly problems: readonly Problem[];
}

/// Result of a task.
export type Answer =
  | CaseInfo
  | MeasuredTable
  | readonly MeasuredColumn[]
  | MotionResult
  | PointResult
  | RunResult
  | TransientResult
  | Float64Array
  | string
  | null;

export type FromWorker =
  | { readonly kind: 'done'; readonly id: number; readonly value: Answer }
  | { readonly kind: 'bad'; readonly id: number; readonly refusal: Refusal }
  | { readonly kind: 'failed'; readonly id: number; readonly message: string }
  | { readonly kind: 'layout'; readonly id: number; readonly layout: PartLayout }
  | { readonly kind: 'points'; readonly id: number; readonly points: PartPoints }
  | { readonly kind: 'run'; readonly id: number; readonly run: RunResult }
  | { readonly kind: 'revolutions'; readonly id: number; readonly count: number };
