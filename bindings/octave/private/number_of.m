function number = number_of(machine)
% NUMBER_OF  By which the gateway knows a machine.
if ~isstruct(machine) || ~isfield(machine, 'number')
    error('whirl:badInput', 'expected a machine of whirl_machine');
end
number = machine.number;
end
