// Types of the module that emscripten makes from explorer/core; the build replaces the name by build/explorer/glue.cjs.
declare module 'whirl-core-glue' {
  export interface CoreModule {
    readonly HEAPU8: Uint8Array;
    readonly HEAPF64: Float64Array;
    UTF8ToString(pointer: number): string;
    stringToUTF8(text: string, pointer: number, size: number): void;
    lengthBytesUTF8(text: string): number;
    _malloc(bytes: number): number;
    _free(pointer: number): void;
    _explorer_message(): number;
    _explorer_case_new(source: number, length: number, name: number): number;
    _explorer_case_free(object: number): void;
    _explorer_assign(object: number, assignment: number): number;
    _explorer_case_text(object: number): number;
    _explorer_describe(object: number): number;
    _explorer_edit(source: number, length: number, path: number, value: number): number;
    _explorer_measured(object: number, name: number, bytes: number, size: number, columns: number): number;
    _explorer_measured_columns(name: number, bytes: number, size: number): number;
    _explorer_measured_orders(): number;
    _explorer_measured_spectrum(turn: number, values: number, count: number, rows: number): number;
    _explorer_plan_new(object: number, batch: number, parameter: number): number;
    _explorer_plan_free(plan: number): void;
    _explorer_plan_number(plan: number, option: number, value: number): number;
    _explorer_plan_method(plan: number, method: number): number;
    _explorer_plan_choose(plan: number, known: number): number;
    _explorer_plan_look(plan: number, transient: number, record: number, steps: number): void;
    _explorer_plan_diagram(plan: number): void;
    _explorer_plan_spectra(plan: number): void;
    _explorer_plan_everything(plan: number, waveform: number): void;
    _explorer_plan_layout(plan: number, value: number): number;
    _explorer_dimension(plan: number): number;
    _explorer_machine(plan: number, value: number): number;
    _explorer_verdict(plan: number, block: number): number;
    _explorer_job_new(plan: number, values: number, count: number, carried: number, start: number): number;
    _explorer_job_free(job: number): void;
    _explorer_job_turn(job: number): number;
    _explorer_job_take(job: number, block: number, end: number): number;
    _explorer_motion_new(plan: number, value: number, state: number, samples: number): number;
    _explorer_motion_free(motion: number): void;
    _explorer_motion_samples(motion: number): number;
    _explorer_motion_contacts(motion: number): number;
    _explorer_motion_turn(motion: number, states: number, forces: number): number;
    _explorer_motion_state(motion: number): number;
    _explorer_plan_orbit(plan: number, revolutions: number): void;
    _explorer_orbit_size(plan: number, revolutions: number, period: number): number;
    _explorer_orbit(
      plan: number,
      value: number,
      revolutions: number,
      period: number,
      nodes: number,
      block: number,
    ): number;
    _explorer_plan_run(plan: number): void;
    _explorer_run_duration(plan: number): number;
    _explorer_run(plan: number, value: number, block: number): number;
    /// Called by _explorer_run after every turn, with the time up to which the block is filled in.
    passed?: ((time: number) => void) | undefined;
  }
  interface CoreOptions {
    readonly wasmBinary: Uint8Array;
    readonly print: () => void;
    readonly printErr: () => void;
  }
  export default function createCore(options: CoreOptions): Promise<CoreModule>;
}
