function number = number_of(machine)
% NUMBER_OF  Returns the number of a machine in the gateway.
if ~isstruct(machine) || ~isfield(machine, 'number')
    error('whirl:badInput', 'expected a machine of whirl_machine');
end
number = machine.number;
end
