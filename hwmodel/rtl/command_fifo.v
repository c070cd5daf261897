// A queue of 2^LOG_DEPTH entries between a source and a sink on one clock.
//
// The head falls through: it stands on o_data from the clock after it was put in, without being
// asked for. The pointers have one bit more than an address, which tells full from empty.
module command_fifo #(
    parameter WIDTH     = 24,
    parameter LOG_DEPTH = 2
) (
    input  wire               i_clk,
    // clears the pointers; nobody sees the entries before they are written
    input  wire               i_rst,
    // an entry, taken when ready
    input  wire               i_valid,
    input  wire [WIDTH-1:0]   i_data,
    output wire               o_ready,
    // the head, gone when ready
    output wire               o_valid,
    output wire [WIDTH-1:0]   o_data,
    input  wire               i_ready,
`ifdef FORMAL
    // all entries, for the properties
    output wire [(WIDTH<<LOG_DEPTH)-1:0] o_entries,
`endif
    // registers
    output reg  [LOG_DEPTH:0] o_write,
    output reg  [LOG_DEPTH:0] o_read
);
    reg [WIDTH-1:0] entries [0:(1<<LOG_DEPTH)-1];

    wire same_place = o_write[LOG_DEPTH-1:0] == o_read[LOG_DEPTH-1:0];
    wire same_round = o_write[LOG_DEPTH] == o_read[LOG_DEPTH];

    assign o_valid = ~(same_place & same_round);
    assign o_ready = ~(same_place & ~same_round);
    assign o_data  = entries[o_read[LOG_DEPTH-1:0]];

    wire put  = i_valid & o_ready;
    wire take = o_valid & i_ready;

    always @(posedge i_clk)
        if (i_rst) begin
            o_write <= {LOG_DEPTH+1{1'b0}};
            o_read  <= {LOG_DEPTH+1{1'b0}};
        end else begin
            if (put) o_write <= o_write + 1'b1;
            if (take) o_read <= o_read + 1'b1;
        end

    always @(posedge i_clk)
        if (put) entries[o_write[LOG_DEPTH-1:0]] <= i_data;

`ifdef FORMAL
    genvar entry;
    generate
        for (entry = 0; entry < 1<<LOG_DEPTH; entry = entry + 1) begin : each
            assign o_entries[entry*WIDTH +: WIDTH] = entries[entry];
        end
    endgenerate
`endif
endmodule
